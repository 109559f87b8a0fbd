// SPDX-License-Identifier: Apache-2.0
// touchstone::scene::Scene: exact contact with many posed objects.
#pragma once

#include "robust/scene/scene.h"

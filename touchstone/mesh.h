// SPDX-License-Identifier: Apache-2.0
// touchstone::Mesh: vertices and faces.
#pragma once

#include "geometry/shapes/mesh.h"

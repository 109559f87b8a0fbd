// SPDX-License-Identifier: Apache-2.0
// touchstone::Pose: a rotation matrix and a translation.
#pragma once

#include "geometry/shapes/pose.h"

// SPDX-License-Identifier: Apache-2.0
// touchstone::fast: answers in plain doubles, for polygons and triangles, and for balls that move.
#pragma once

#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"
#include "geometry/contact/fast_triangle.h"

// SPDX-License-Identifier: Apache-2.0
// touchstone::fast: answers in plain doubles, for polygons and triangles.
#pragma once

#include "geometry/contact/fast.h"
#include "geometry/contact/fast_triangle.h"

// SPDX-License-Identifier: Apache-2.0
// touchstone::Polygon: one outer loop and any number of holes.
#pragma once

#include "geometry/shapes/polygon.h"

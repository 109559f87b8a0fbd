// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/triangle.h"

namespace touchstone::filtered {

/// Throws Rejected if exact::validate rejects the triangle as a polygon. Requires round to nearest, without
/// flush-to-zero. Cost: about 10 ns; 2 us if doubles do not find a component of the normal that is certainly not zero.
void expect_valid(const Triangle& triangle);

}  // namespace touchstone::filtered

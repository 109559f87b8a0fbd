// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace touchstone::cell {

/// The point (cosine / denominator, sine / denominator) of the unit circle, exactly: all three are integers, and
/// cosine^2 + sine^2 = denominator^2. Each is below 2^42 in magnitude and so an exact double.
struct CirclePoint {
  std::int64_t cosine, sine, denominator;
};

/// Returns the corners of a polygon in the unit circle, counter-clockwise from (1, 0), close to those of the regular
/// polygon: the tangent of half the angle from the last axis is rounded to a multiple of 2^-20, so that every corner is
/// within 2^-20 of its regular place. A quarter turn maps the polygon to itself if 4 divides the number of sides.
///
/// Requires 3 <= sides <= 1000. The tangents are the C library's: errors in their last bits change a corner only if a
/// tangent is next to the middle between two multiples of 2^-20.
[[nodiscard]] std::vector<CirclePoint> circle_points(int sides);

}  // namespace touchstone::cell

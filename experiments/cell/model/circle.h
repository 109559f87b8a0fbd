// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace touchstone::cell {

/// The point (cosine / denominator, sine / denominator) of the unit circle, exactly: all are whole, and
/// cosine^2 + sine^2 = denominator^2. Each is below 2^42 in magnitude, so that it is a double.
struct CirclePoint {
  std::int64_t cosine, sine, denominator;
};

/// The corners of a polygon in the unit circle, counter-clockwise from (1, 0), next to those of the regular one: the
/// tangent of half the angle from the last axis is rounded to a multiple of 2^-20, so that no corner is farther than
/// 2^-20 from where it would be. A quarter turn maps the polygon to itself where 4 divides the sides.
///
/// Requires 3 <= sides <= 1000. The tangents are the C library's: to change a corner, their last bits would have to be
/// wrong where they meet the middle between two multiples of 2^-20.
[[nodiscard]] std::vector<CirclePoint> circle_points(int sides);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <vector>

#include "experiments/thesis/cell/model/solid.h"
#include "geometry/shapes/polygon.h"

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

/// The boundary of a solid, exact except for the rounding of its loops.
struct Boundary {
  /// A face's loops, the outer one first and counter-clockwise seen from outside, the holes clockwise; every vertex
  /// rounded to the nearest double in each coordinate. Loops that share a vertex before rounding share it afterwards.
  using Loops = std::vector<Loop>;
  std::vector<Loops> faces;  ///< in an order that depends on these coordinates alone
  mpq_class volume;          ///< before rounding
};

/// Evaluates a solid of boxes and cylinders exactly. Coplanar neighbouring faces are one.
///
/// Requires a solid that holds no mesh. Throws std::invalid_argument for a pose that does not keep orientation (its
/// determinant is not positive). Source: [hachenberger2007], as CGAL's Nef_polyhedron_3 (GPL).
[[nodiscard]] Boundary boundary_of(const Solid& solid);

}  // namespace touchstone::cell

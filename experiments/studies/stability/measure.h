// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "geometry/shapes/polygon.h"

/// What a stress really is, on the doubles of a polygon: in rationals, rounded at the end to about 1e-15 of it. So a
/// scene says of itself what its level says.
namespace touchstone::stability {

/// The distance of the two vertices that are farthest apart over the width perpendicular to it, in the supporting plane
/// of the first loop: of a triangle, its longest side over the height on it; of a square, 1. Requires a normal.
/// Cost: quadratic.
[[nodiscard]] double aspect_ratio(const Polygon& polygon);

/// The sine of the angle between the lines of the two edges that meet at a vertex.
[[nodiscard]] double sine_at(const Polygon& polygon, std::size_t vertex);

/// The distance of two vertices over the longest side of the polygon's box.
[[nodiscard]] double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second);

/// The distance of vertex 0 from zero over the longest side of the polygon's box.
[[nodiscard]] double relative_origin_distance(const Polygon& polygon);

/// The exponent of the largest coordinate.
[[nodiscard]] int largest_exponent(const Polygon& polygon);

}  // namespace touchstone::stability

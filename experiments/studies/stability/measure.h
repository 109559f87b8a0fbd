// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "geometry/shapes/polygon.h"

/// The actual stress of a polygon of doubles, computed in rationals and finally rounded to a relative 1e-15 or so. It
/// verifies that a scene has the stress of its level.
namespace touchstone::stability {

/// Returns the distance of the two farthest vertices divided by the width perpendicular to their connection, in the
/// supporting plane of the first loop: for a triangle, its longest side over the height on it; for a square, 1.
/// Requires a normal. Cost: quadratic.
[[nodiscard]] double aspect_ratio(const Polygon& polygon);

/// Returns the sine of the angle between the lines of the two edges that meet at a vertex.
[[nodiscard]] double sine_at(const Polygon& polygon, std::size_t vertex);

/// Returns the distance of two vertices divided by the longest side of the polygon's box.
[[nodiscard]] double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second);

/// Returns the distance of vertex 0 from the origin divided by the longest side of the polygon's box.
[[nodiscard]] double relative_origin_distance(const Polygon& polygon);

/// Returns the exponent of the largest coordinate.
[[nodiscard]] int largest_exponent(const Polygon& polygon);

}  // namespace touchstone::stability

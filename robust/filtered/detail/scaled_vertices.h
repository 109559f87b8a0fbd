// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::filtered {

/// A vertex in a frame's unit of length: x, y, z, and 0.
struct ScaledVertex {
  double coordinates[4];
};

/// Returns the exponent of a frame's unit of length: no vertex is farther than 1/4 from vertex 0 in any coordinate.
[[nodiscard]] int frame_exponent(const Polygon& polygon);

/// Returns the vertices in the unit 2^exponent; nothing if that loses a bit. Requires round to nearest, and subnormal
/// numbers.
[[nodiscard]] std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, int exponent);

}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/length_unit.h"

namespace touchstone::filtered {

/// A vertex in a frame's unit of length: x, y, z, and 0.
struct ScaledVertex {
  double coordinates[4];
};

/// Returns a frame's unit of length: no vertex is farther than 1/4 from vertex 0 in any coordinate.
[[nodiscard]] LengthUnit frame_unit(const Polygon& polygon);

/// Returns the vertices in this unit; nothing if that loses a bit. Requires round to nearest, and subnormal
/// numbers.
[[nodiscard]] std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, const LengthUnit& unit);

}  // namespace touchstone::filtered

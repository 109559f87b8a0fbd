// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/scaled_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::filtered {

LengthUnit frame_unit(const Polygon& polygon) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    for (const double x : coordinates) extent = std::max(extent, std::abs(x / 4 - coordinates[0] / 4));
  }
  // A quarter of the smallest numbers may round to zero.
  return LengthUnit(std::ilogb(std::max(extent, std::numeric_limits<double>::denorm_min())) + 5);
}

std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, const LengthUnit& unit) {
  const std::span<const double> given[] = {polygon.coordinates(0), polygon.coordinates(1), polygon.coordinates(2)};
  std::vector<ScaledVertex> result(polygon.vertex_count());
  bool lossless = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[i].coordinates[axis] = unit.scaled(given[axis][i]);
      lossless &= unit.is_exact(given[axis][i]);
    }
  if (!lossless) return std::nullopt;
  return result;
}

}  // namespace touchstone::filtered

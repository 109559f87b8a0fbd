// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/scaled_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::filtered {

int frame_exponent(const Polygon& polygon) {
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    for (const double x : coordinates) extent = std::max(extent, std::abs(x / 4 - coordinates[0] / 4));
  }
  // A quarter of the smallest numbers may round to zero.
  return std::ilogb(std::max(extent, std::numeric_limits<double>::denorm_min())) + 5;
}

std::optional<std::vector<ScaledVertex>> scaled_vertices(const Polygon& polygon, int exponent) {
  const int half = exponent / 2;
  const double down[] = {std::ldexp(1.0, -half), std::ldexp(1.0, half - exponent)};
  const double up[] = {std::ldexp(1.0, half), std::ldexp(1.0, exponent - half)};
  const std::span<const double> given[] = {polygon.coordinates(0), polygon.coordinates(1), polygon.coordinates(2)};
  std::vector<ScaledVertex> result(polygon.vertex_count());
  bool lossless = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double& scaled = result[i].coordinates[axis];
      scaled = given[axis][i] * down[0] * down[1];
      lossless &= scaled * up[0] * up[1] == given[axis][i];  // exact: factors are powers of two
    }
  if (!lossless) return std::nullopt;
  return result;
}

}  // namespace touchstone::filtered

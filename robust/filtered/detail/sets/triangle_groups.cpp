// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/sets/triangle_groups.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "robust/filtered/detail/triangle/triangle_lanes.h"

namespace touchstone::filtered::detail {
namespace {

/// Returns a coordinate in steps.
std::int16_t to_steps(double given, double origin, double scale) {
  const lane::Seen<double> seen(given, origin, scale);
  return static_cast<std::int16_t>(std::lrint(lane::in_steps<double>(seen.in_units, TriangleGroup::kSteps)));
}

}  // namespace

TriangleGroup group_of(std::span<const Triangle> triangles) {
  TriangleGroup group{};
  group.reach = -1;
  const auto each_vertex = [triangles](const auto& visit) {
    for (const Triangle& t : triangles)
      for (const Eigen::Vector3d* vertex : {&t.a, &t.b, &t.c}) visit(*vertex);
  };
  double extent = 0;
  for (int k = 0; k < 3; ++k) {
    double low = triangles[0].a[k], high = low;
    each_vertex([&](const Eigen::Vector3d& p) { low = std::min(low, p[k]), high = std::max(high, p[k]); });
    group.origin[k] = low / 2 + high / 2;
    extent = std::max({extent, high - group.origin[k], group.origin[k] - low});
  }
  // Beyond these limits the scale, or a ball's subnormal number that was flushed and then scaled, would be too large.
  bool is_prepared = extent >= 0x1p-900 && extent <= 0x1p500;
  for (int k = 0; k < 3; ++k) is_prepared = is_prepared && std::abs(group.origin[k]) <= TriangleGroup::kLargest;
  if (!is_prepared) {
    for (double& coordinate : group.origin) coordinate = 0;  // queries subtract it, which must not overflow
    return group;
  }

  // Within a power of two of the radius, so that no square underflows or overflows.
  const double power = std::ldexp(1.0, -std::ilogb(extent));
  double radius = 0;
  each_vertex([&](const Eigen::Vector3d& p) {
    radius = std::max(radius, (power * (p - Eigen::Vector3d(group.origin))).norm());
  });
  group.scale = (1 - TriangleGroup::kSpare) / radius * power;  // rounding moves no vertex beyond the radius
  group.reach = TriangleGroup::kReach / group.scale;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    const Triangle& triangle = triangles[lane];
    const Eigen::Vector3d* const vertices[] = {&triangle.a, &triangle.b, &triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        group.vertices[i][k][lane] = to_steps((*vertices[i])[k], group.origin[k], group.scale);
    }
  }
  return group;
}

}  // namespace touchstone::filtered::detail

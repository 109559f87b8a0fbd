// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/sets/triangle_groups.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace touchstone::filtered::detail {
namespace {

std::int16_t to_steps(double number) { return static_cast<std::int16_t>(std::lrint(number * TriangleGroup::kSteps)); }

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
  const auto scaled = [&group](const Eigen::Vector3d& p, double scale) -> Eigen::Vector3d {
    return scale * (p - Eigen::Vector3d(group.origin));
  };
  double radius = 0;
  each_vertex([&](const Eigen::Vector3d& p) { radius = std::max(radius, scaled(p, power).norm()); });
  group.scale = (1 - 0x1p-40) / radius * power;  // rounding moves no vertex beyond the radius
  group.reach = TriangleGroup::kReach / group.scale;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
    const Triangle& triangle = triangles[lane];
    const Eigen::Vector3d* const vertices[] = {&triangle.a, &triangle.b, &triangle.c};
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d vertex = scaled(*vertices[i], group.scale);
      for (int k = 0; k < 3; ++k) group.vertices[i][k][lane] = to_steps(vertex[k]);
    }
  }
  return group;
}

}  // namespace touchstone::filtered::detail

// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/triangle_groups.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robust/filtered/detail/vector3.h"

namespace touchstone::filtered {
namespace {

using Vector = Vector3<double>;

Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// Below this share of the product of two edges' lengths a normal is not known well enough.
constexpr double kFlattest = 0x1p-28;
/// Edges are at least this long in the group's units, so that no product of them underflows.
constexpr double kShortest = 0x1p-200;

std::int16_t to_steps(double number) { return static_cast<std::int16_t>(std::lrint(number * TriangleGroup::kSteps)); }

/// A length times a power of two, relative to a group's origin; edges are differences of the given vertices, so that
/// their errors are relative to their own lengths.
class GroupUnits {
 public:
  GroupUnits(const double (&origin)[4], double scale) : origin_{origin[0], origin[1], origin[2]}, scale_(scale) {}
  [[nodiscard]] Vector point(const Eigen::Vector3d& p) const {
    return scale_ * (Vector{p.x(), p.y(), p.z()} - origin_);
  }
  [[nodiscard]] Vector edge(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return scale_ * Vector{to.x() - from.x(), to.y() - from.y(), to.z() - from.z()};
  }

 private:
  Vector origin_;
  double scale_;
};

/// Stores a triangle in a lane, if its edges and its normal are known well enough.
void prepare_lane(TriangleGroup& group, std::size_t lane, const Triangle& triangle) {
  const GroupUnits units(group.origin, group.scale);
  const std::array<Vector, 3> edge{units.edge(triangle.a, triangle.b), units.edge(triangle.b, triangle.c),
                                   units.edge(triangle.c, triangle.a)};
  const std::array<double, 3> lengths{length(edge[0]), length(edge[1]), length(edge[2])};
  const Vector normal = cross(edge[0], edge[1]);
  const double area = length(normal);
  if (!(std::min({lengths[0], lengths[1], lengths[2]}) >= kShortest)) return;
  if (!(area >= kFlattest * lengths[0] * lengths[1])) return;

  const Vector x = 1 / lengths[0] * edge[0], z = 1 / area * normal, y = cross(z, x);
  const std::array<Vector, 3> middle{units.point(triangle.a) + 0.5 * edge[0], units.point(triangle.b) + 0.5 * edge[1],
                                     units.point(triangle.c) + 0.5 * edge[2]};
  const std::array<Vector, 3> axes{x, y, z};
  for (std::size_t k = 0; k < 3; ++k) {
    for (int component = 0; component < 3; ++component) group.axis[k][component][lane] = to_steps(axes[k][component]);
    group.offset[k][lane] = to_steps(-dot(axes[k], middle[0]));
  }
  group.half[lane] = to_steps(lengths[0] / 2);
  for (std::size_t i = 1; i < 3; ++i) {
    TriangleGroup::Edge& stored = group.edges[i - 1];
    const double inward_x = -dot(edge[i], y) / lengths[i], inward_y = dot(edge[i], x) / lengths[i];
    const Vector to_middle = middle[i] - middle[0];
    const double middle_x = dot(to_middle, x), middle_y = dot(to_middle, y);
    stored.inward_x[lane] = to_steps(inward_x);
    stored.inward_y[lane] = to_steps(inward_y);
    stored.depth[lane] = to_steps(-(inward_x * middle_x + inward_y * middle_y));
    stored.along[lane] = to_steps(inward_x * middle_y - inward_y * middle_x);
    stored.half[lane] = to_steps(lengths[i] / 2);
  }
  group.prepared |= 1U << lane;
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

  const double power = std::ldexp(1.0, -std::ilogb(extent));
  const GroupUnits powers(group.origin, power);
  double radius = 0;
  each_vertex([&](const Eigen::Vector3d& p) { radius = std::max(radius, length(powers.point(p))); });
  group.scale = (1 - 0x1p-40) / radius * power;  // rounding moves no vertex beyond the radius
  group.reach = TriangleGroup::kReach / group.scale;
  for (std::size_t i = 0; i < triangles.size(); ++i) prepare_lane(group, i, triangles[i]);
  return group;
}

}  // namespace touchstone::filtered

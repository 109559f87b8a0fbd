// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/signs/sign_ladder.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"

/// How a ray along a coordinate axis crosses a triangle, by exact signs.
///
/// The ray starts at the point plus (e, e^2) in the two other coordinates, for every e > 0 that is small enough. So it
/// meets no edge and no vertex, and lies in the plane of no triangle. Source: [edelsbrunner1990].
namespace touchstone::filtered::detail {

/// A ray from a point along a coordinate axis.
struct AxisRay {
  Ball point;  ///< of radius 0
  int axis;    ///< 0, 1 or 2
  bool up;     ///< whether it runs towards larger coordinates

  /// @{
  /// The other two axes, in the order in which a turn from the first to the second is to the left, seen against `axis`.
  [[nodiscard]] int first() const { return axis == 2 ? 0 : axis + 1; }
  [[nodiscard]] int second() const { return axis == 0 ? 2 : axis - 1; }
  /// @}
};

inline namespace TOUCHSTONE_TARGET {

[[nodiscard]] inline double largest_part(const Vector3<DoubleDouble>& v) {
  return std::max(std::max(std::abs(v.x.high), std::abs(v.y.high)), std::abs(v.z.high));
}

/// Returns the sign of the turn from a over b to p, seen against an axis: left (+), straight on (0), right (-).
[[nodiscard]] inline int turn(const double* a, const double* b, const double* p, int axis) {
  const auto across = [axis](const double* to, const double* from) -> Vector3<DoubleDouble> {
    const auto part = [&](int k) { return k == axis ? DoubleDouble() : two_difference(to[k], from[k]); };
    return {part(0), part(1), part(2)};
  };
  const auto part_of_axis = [axis](int k) { return DoubleDouble(k == axis ? 1.0 : 0.0); };
  const Vector3<DoubleDouble> to_point = across(p, a), edge = across(b, a);
  const Vector3<DoubleDouble> normal{part_of_axis(0), part_of_axis(1), part_of_axis(2)};
  const Maxima maxima{largest_part(to_point), largest_part(edge), 1};
  const auto bigint = [&] { return bigint_turn(a, b, p, axis); };
  if (!(maxima.to_center <= bounds::kLargest && maxima.edge <= bounds::kLargest)) return bigint();
  NoCounts counts;
  return exact_sign<SignKind::Side>(EdgeOperands{to_point, edge, normal, 0, 0, maxima, false, nullptr, true}, counts,
                                    bigint);
}

/// Returns the sign of the turn from a over b to where the ray starts; 0 only if the edge is parallel to the ray.
[[nodiscard]] inline int turn(const double* a, const double* b, const AxisRay& ray) {
  if (const int sign = turn(a, b, ray.point.center.data(), ray.axis)) return sign;
  const int u = ray.first(), v = ray.second();
  return a[v] != b[v] ? (a[v] > b[v] ? 1 : -1) : (b[u] > a[u]) - (b[u] < a[u]);  // exact
}

/// Returns on which side of the triangle's plane the point lies: in front (+), on it (0), behind (-).
[[nodiscard]] inline int side_of_plane(const BallTriangleView& view) {
  const double to_center = largest_part(exact_difference(view.center, view.vertex[0]));
  const double edge = std::max(largest_part(exact_edge(view, 0)), largest_part(exact_edge(view, 1)));
  if (!(to_center <= bounds::kLargest && edge <= bounds::kLargest)) return bigint_sign(SignKind::Front, view, 0);
  NoCounts counts;
  return exact_sign<SignKind::Front>(view, {to_center, edge, 0}, 0, counts);
}

/// Returns +1 if the ray leaves through the triangle, -1 if it enters, 0 if it does not cross it; the front is outside.
/// Requires a point that is not on the triangle, round to nearest, and no flush-to-zero.
[[nodiscard]] inline int crossing(const BallTriangleView& view, const AxisRay& ray) {
  const int orientation = turn(view.vertex[0], view.vertex[1], ray);
  if (orientation == 0 || turn(view.vertex[1], view.vertex[2], ray) != orientation ||
      turn(view.vertex[2], view.vertex[0], ray) != orientation)
    return 0;
  const bool above = side_of_plane(view) == orientation;
  return above == ray.up ? 0 : ray.up ? orientation : -orientation;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered::detail

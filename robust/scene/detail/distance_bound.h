// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geometry/shapes/triangle.h"
#include "robust/filtered/detail/numbers/vector3.h"

/// Upper bounds of distances from triangles, in doubles.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {
namespace distance_bound {

/// A point of a triangle, combined from vertices whose coordinates are at most m as seen from the centre, is known to
/// kPoint m. Its distance from the centre is known to a factor of kWide, which also covers the rounding of the bound.
/// Proved in tests/robust/proofs/distance_bound_test.cpp.
inline constexpr double kPoint = 20 * 0x1p-53;
inline constexpr double kWide = 1 + 0x1p-49;
/// The limits of m, so that no product of four numbers overflows, and what squares lose to underflow is less than
/// kPoint m.
inline constexpr double kSmallest = 0x1p-200, kLargest = 0x1p200;

/// Returns a x + b y + c z.
template <class T>
constexpr filtered::detail::Vector3<T> combined(const T& a, const filtered::detail::Vector3<T>& x, const T& b,
                                                const filtered::detail::Vector3<T>& y, const T& c,
                                                const filtered::detail::Vector3<T>& z) {
  const auto sum = [&](const T& p, const T& q, const T& r) { return a * p + b * q + c * r; };
  return {sum(x.x, y.x, z.x), sum(x.y, y.y, z.y), sum(x.z, y.z, z.z)};
}

/// Returns the sum of three weights, of which each has a share.
template <class T>
constexpr T sum_of(const T& a, const T& b, const T& c) {
  return a + b + c;
}
/// Returns the distance of a point, squared.
template <class T>
constexpr T squared_distance(const filtered::detail::Vector3<T>& point) {
  return dot(point, point);
}
/// Returns at least the distance of a point whose computed one is this, where coordinates are at most `largest`.
template <class T>
constexpr T not_below(const T& computed, const T& largest) {
  using filtered::detail::constant;
  return (computed + constant<T>(kPoint) * largest) * constant<T>(kWide);
}

}  // namespace distance_bound

/// Returns at least the distance of the centre from the triangle, and little more unless the triangle is a needle;
/// infinite if its numbers, as seen from the centre, are beyond the limits above. Requires round to nearest, without
/// flush-to-zero.
///
/// Finds a point of the triangle that is nearly the closest. Whichever it is, the triangle is not farther: the point is
/// combined from vertices with weights from 0 to 1 whose sum is 1, rounded.
inline double distance_at_most(const Eigen::Vector3d& center, const Triangle& triangle) {
  using Vector = filtered::detail::Vector3<double>;
  using distance_bound::combined;
  const auto seen = [&center](const Eigen::Vector3d& p) -> Vector {
    return {p.x() - center.x(), p.y() - center.y(), p.z() - center.z()};
  };
  const auto difference = [](const Vector& a, const Vector& b) -> Vector { return {a.x - b.x, a.y - b.y, a.z - b.z}; };
  const Vector vertex[] = {seen(triangle.a), seen(triangle.b), seen(triangle.c)};
  double largest = 0;
  for (const Vector& v : vertex) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest >= distance_bound::kSmallest && largest <= distance_bound::kLargest))
    return std::numeric_limits<double>::infinity();

  const Vector edge[] = {difference(vertex[1], vertex[0]), difference(vertex[2], vertex[1]),
                         difference(vertex[0], vertex[2])};
  const Vector normal = cross(edge[0], edge[1]);
  double weight[3];  // of the vertices opposite to the edges
  for (std::size_t i = 0; i < 3; ++i) weight[i] = dot(normal, cross(vertex[i], edge[i]));
  const double sum = distance_bound::sum_of(weight[0], weight[1], weight[2]);
  double squared = std::numeric_limits<double>::infinity();
  if (weight[0] > 0 && weight[1] > 0 && weight[2] > 0 && sum < squared) {
    const Vector foot = combined(weight[0] / sum, vertex[2], weight[1] / sum, vertex[0], weight[2] / sum, vertex[1]);
    squared = distance_bound::squared_distance(foot);
  } else {
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = -dot(vertex[i], edge[i]), length_sq = dot(edge[i], edge[i]);
      const double end = along <= 0 ? 0 : along >= length_sq ? 1 : along / length_sq;
      const Vector point = combined(1 - end, vertex[i], end, vertex[(i + 1) % 3], 0.0, vertex[i]);
      squared = std::min(squared, distance_bound::squared_distance(point));
    }
  }
  return distance_bound::not_below(std::sqrt(squared), largest);
}

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

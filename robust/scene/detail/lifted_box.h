// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/bvh/box.h"
#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::scene::detail {

/// The plane of a polygon's outer loop in rounded arithmetic, and the heights of vertices above it; over any number
/// type, for the error calculus of robust/proofs.
///
/// For n vertices, in round to nearest, with u = 2^-53: coordinates are relative to one point, so they are rounded
/// once, and are at most e. Then the error of a component of the normal is less than kNormal n^2 u e^2, and that of
/// N.(mean - vertex) is less than kHeight n^2 u e^3. This covers the rounding of these bounds, of a component minus its
/// error, and of the height plus its error over such a component. Proved in tests/robust/proofs/rounded_plane_test.cpp
/// for n from 3 to kMostVertices and e from kSmallestSize, including underflow.
namespace rounded_plane {

inline constexpr double kNormal = 6;
inline constexpr double kHeight = 91;
inline constexpr double kMostVertices = 0x1p20;
inline constexpr double kSmallestSize = 0x1p-300;

template <class Number>
struct Plane {
  filtered::detail::Vector3<Number> normal;  ///< Newell's
  filtered::detail::Vector3<Number> mean;
};

/// Returns the plane of a loop of `count` vertices; at(i) returns vertex i as a Vector3.
template <class Number, class At>
Plane<Number> plane_of(std::size_t count, const Number& zero, const At& at) {
  using filtered::detail::Vector3, filtered::detail::cross;
  const auto sum = [](const Vector3<Number>& a, const Vector3<Number>& b) {
    return Vector3<Number>{a.x + b.x, a.y + b.y, a.z + b.z};
  };
  Vector3<Number> normal{zero, zero, zero}, mean = normal;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3<Number> here = at(i);
    normal = sum(normal, cross(here, at(i + 1 == count ? 0 : i + 1)));
    mean = sum(mean, here);
  }
  const auto n = static_cast<double>(count);
  return {normal, {mean.x / n, mean.y / n, mean.z / n}};
}

/// Returns N.(mean - vertex): the distance of the vertex from the plane, with sign, times the length of the normal.
template <class Number>
Number height(const Plane<Number>& plane, const filtered::detail::Vector3<Number>& vertex) {
  const filtered::detail::Vector3<Number> to_mean{plane.mean.x - vertex.x, plane.mean.y - vertex.y,
                                                  plane.mean.z - vertex.z};
  return dot(plane.normal, to_mean);
}

}  // namespace rounded_plane

/// Returns a box that contains the lifted polygon, or the part of it within the finite doubles: points beyond them only
/// come nearer to every centre if they are moved back to the largest double. Requires round to nearest, without
/// flush-to-zero.
[[nodiscard]] Box lifted_box(const Polygon& polygon, const filtered::PreparedPolygon& prepared);

/// The same, at most 2^-20 of the polygon's size larger, computed in doubles only; nothing if the normal is not precise
/// enough in doubles. Cost: about 10 ns per vertex.
[[nodiscard]] std::optional<Box> quick_lifted_box(const Polygon& polygon);

}  // namespace touchstone::scene::detail

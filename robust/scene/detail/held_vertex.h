// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/scene/detail/shared_vertices.h"

/// The quickest proof that a ball touches a triangle: it holds a vertex.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {
namespace held_vertex {

/// Multiplied with the square of a radius to cover its rounding and that of the squares that are compared with it.
/// Proved in tests/robust/proofs/held_vertex_test.cpp, as are the limits of radii, between which no underflow matters.
inline constexpr double kNarrow = 1 - 0x1p-49;
inline constexpr double kSmallest = 0x1p-480, kLargest = 0x1p480;

/// Returns the limit for the squares of the distances of vertices.
template <class T>
constexpr T squared_limit(const T& radius) {
  return radius * radius * filtered::detail::constant<T>(kNarrow);
}

/// Returns the square of the distance of a vertex, less that limit. `from`: the vertex as seen from the centre.
template <class T>
constexpr T beyond(const filtered::detail::Vector3<T>& from, const T& limit) {
  return dot(from, from) - limit;
}

}  // namespace held_vertex

/// A ball that looks for vertices in it. Requires round to nearest, without flush-to-zero.
class VertexFinder {
 public:
  explicit VertexFinder(const Ball& ball)
      : center_(ball.center),
        limit_(ball.radius >= held_vertex::kSmallest && ball.radius <= held_vertex::kLargest
                   ? held_vertex::squared_limit(ball.radius)
                   : -1) {}

  /// Returns whether the ball certainly holds a vertex of the triangle.
  [[nodiscard]] TOUCHSTONE_INLINE bool finds(const SharedTriangle& triangle) const {
    const auto seen = [&](int axis) {
      return filtered::detail::all_lanes(center_[axis]) -
             filtered::detail::pack(triangle.a[axis], triangle.b[axis], triangle.c[axis], triangle.c[axis]);
    };
    const filtered::detail::Vector3<filtered::detail::Pack> from{seen(0), seen(1), seen(2)};
    return negative_lanes(held_vertex::beyond(from, filtered::detail::all_lanes(limit_))) != 0;
  }

 private:
  Eigen::Vector3d center_;
  double limit_;
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

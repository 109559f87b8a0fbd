// SPDX-License-Identifier: Apache-2.0
#include "robust/mesh/detail/face_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/detail/exact_kernel.h"
#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/detail/nearest_double.h"

namespace touchstone::mesh::detail {
namespace {

using Eigen::Vector3d;

std::pair<double, double> seen(const Vector3d& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

int turn_of(const std::array<Vector3d, 3>& corners, int axis) {
  const auto [ax, ay] = seen(corners[0], axis);
  const auto [bx, by] = seen(corners[1], axis);
  const auto [cx, cy] = seen(corners[2], axis);
  return exact::detail::orientation(ax, ay, bx, by, cx, cy);
}

/// A vertex and its neighbours.
std::array<Vector3d, 3> corner(const Polygon& polygon, std::size_t vertex) {
  return {polygon.vertex(polygon.previous(vertex)), polygon.vertex(vertex), polygon.vertex(polygon.next(vertex))};
}

/// Returns the lexicographically lowest vertex of the loop and its neighbours. They have the orientation of the loop,
/// because no valid loop runs straight there. If the loop visits that point several times, takes the visit with the
/// first edge in counterclockwise order: no other visit encloses that one.
std::array<Vector3d, 3> lowest_corner(const Polygon& polygon, std::size_t loop, int axis) {
  const auto first_end = [&](std::size_t vertex) -> Vector3d {
    const auto [before, here, after] = corner(polygon, vertex);
    return turn_of({here, before, after}, axis) > 0 ? before : after;
  };
  std::size_t lowest = polygon.loop_begin(loop);
  for (std::size_t i = lowest + 1; i < polygon.loop_end(loop); ++i) {
    const auto here = seen(polygon.vertex(i), axis), least = seen(polygon.vertex(lowest), axis);
    if (here < least || (here == least && turn_of({polygon.vertex(i), first_end(i), first_end(lowest)}, axis) > 0))
      lowest = i;
  }
  return corner(polygon, lowest);
}

}  // namespace

int turn(const Polygon& polygon, std::size_t loop, int axis) {
  return turn_of(lowest_corner(polygon, loop, axis), axis);
}

FacePlane::FacePlane(const Polygon& face)
    : axis_(exact::detail::dropped_axis(face).value()), corners_(lowest_corner(face, 0, axis_)) {}

bool FacePlane::contains(const Vector3d& point) const {
  return exact::detail::coplanar(corners_[0], corners_[1], corners_[2], point);
}

int FacePlane::turn(int axis) const { return turn_of(corners_, axis); }

double FacePlane::approximate_height(const Vector3d& point) const {
  const Vector3d normal = (corners_[1] - corners_[0]).cross(corners_[2] - corners_[0]);
  return std::abs(normal.dot(point - corners_[1]) / normal[axis_]);
}

double off_plane(const Polygon& polygon, std::span<const Vector3d> points) {
  using exact::detail::Number, exact::detail::Vector, exact::detail::vector;
  const std::size_t outer = polygon.loop_end(0);
  Vector normal(0, 0, 0), sum(0, 0, 0);
  for (std::size_t i = 0; i < outer; ++i) {
    const Vector vertex = vector(polygon.vertex(i));
    normal = normal + kernel::cross_product(vertex, vector(polygon.vertex(polygon.next(i))));
    sum = sum + vertex;
  }
  // All heights times the number n of vertices in the outer loop: n N.(p - g).
  const Number n(static_cast<int>(outer)), plane = normal * sum;
  Number farthest(0);
  for (const Vector3d& point : points)
    farthest = std::max(farthest, Number(kernel::abs(Number(n * (normal * vector(point)) - plane))));
  const Number scale = n * kernel::abs(normal[exact::detail::dropped_axis(polygon).value()]);
  return rounded(farthest, scale, exact::detail::nearest_double);
}

}  // namespace touchstone::mesh::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/target.h"
#include "robust/filtered/detail/vector3.h"

/// The distance from a point to a triangle of a TriangleSet, in an isometric frame of the triangle: axis x along edge
/// 0, whose middle is the origin; axis y in the triangle's plane, into the triangle; axis z along its normal.
///
/// Each operation is written once, over any number type. robust/proofs records the operations on coordinates and on
/// edges, and proves their constants of bounds.h.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {
namespace lane {

/// Returns a coordinate of a point in the frame. `from_origin` is the point relative to the group's origin, and
/// `offset` is the coordinate of that origin.
template <class T>
constexpr auto coordinate(const Vector3<T>& axis, const Vector3<T>& from_origin, const T& offset) {
  return multiply_add(axis.x, from_origin.x,
                      multiply_add(axis.y, from_origin.y, multiply_add(axis.z, from_origin.z, offset)));
}

/// Returns how far the foot (x, y) lies on the inner side of an edge's line. (inward_x, inward_y) is the unit normal of
/// the edge in the plane, and `offset` is the value for the foot (0, 0).
template <class T>
constexpr auto depth(const T& x, const T& y, const T& inward_x, const T& inward_y, const T& offset) {
  return multiply_add(inward_x, x, multiply_add(inward_y, y, offset));
}

/// Returns how far the foot lies beyond the middle of the edge, in its direction (inward_y, -inward_x). `offset` is the
/// value for the foot (0, 0).
template <class T>
constexpr auto along(const T& x, const T& y, const T& inward_x, const T& inward_y, const T& offset) {
  return multiply_subtract(inward_y, x, multiply_subtract(inward_x, y, offset));
}

/// Returns the squared distance from the foot to an edge of length 2 `half`.
template <class T>
constexpr auto squared_edge_distance(const T& depth, const T& along, const T& half, const T& zero) {
  const T overshoot = maximum(magnitude(along) - half, zero);
  return multiply_add(depth, depth, overshoot * overshoot);
}

}  // namespace lane
}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

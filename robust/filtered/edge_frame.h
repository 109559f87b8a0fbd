// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/target.h"
#include "robust/filtered/vector3.h"

/// The operations of the isometric frame in which a prepared polygon is looked at: origin, two orthonormal axes in
/// the supporting plane and the unit normal. All lengths are in units of the polygon's size, so that magnitudes and
/// errors are absolute.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {
namespace frame {

/// Axis.(c - origin): a coordinate of the centre in the frame, in the plane or above it.
template <class A, class V>
constexpr auto coordinate(const Vector3<A>& axis, const Vector3<V>& from_origin) {
  return dot(axis, from_origin);
}

/// How far the foot (x, y) lies along the direction of an edge that starts at (start_x, start_y).
template <class T>
constexpr auto along(const T& x, const T& y, const T& start_x, const T& start_y, const T& direction_x,
                     const T& direction_y) {
  return (x - start_x) * direction_x + (y - start_y) * direction_y;
}

/// How far the foot lies to the left of the edge's line.
template <class T>
constexpr auto across(const T& x, const T& y, const T& start_x, const T& start_y, const T& direction_x,
                      const T& direction_y) {
  return (y - start_y) * direction_x - (x - start_x) * direction_y;
}

}  // namespace frame
}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

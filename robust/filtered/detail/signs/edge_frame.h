// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/signs/bounds.h"

/// The operations in the isometric frame of a prepared polygon: origin, two orthonormal axes in the supporting plane,
/// and the unit normal. All lengths are in units of the polygon's size, so that bounds of magnitudes and errors are
/// absolute.
///
/// Numbers may be doubles of one ball, lanes of four edges or four balls, and numbers that carry the bounds of their
/// errors for the proofs (tests/robust/proofs/frame_test.cpp).
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {
namespace frame {

/// Returns axis.(c - origin): a coordinate of the centre in the frame, in the plane or above it.
template <class A, class V>
constexpr auto coordinate(const Vector3<A>& axis, const Vector3<V>& from_origin) {
  return dot(axis, from_origin);
}

/// Returns the height of the centre above a plane that lies plane_height above the origin.
template <class A, class V, class T>
constexpr auto height(const Vector3<A>& normal, const Vector3<V>& from_origin, const T& plane_height) {
  return coordinate(normal, from_origin) - plane_height;
}

/// Returns how far the foot (x, y) lies along the direction of an edge that starts at (start_x, start_y).
template <class T>
constexpr auto along(const T& x, const T& y, const T& start_x, const T& start_y, const T& direction_x,
                     const T& direction_y) {
  return (x - start_x) * direction_x + (y - start_y) * direction_y;
}

/// Returns how far the foot lies to the left of the edge's line.
template <class T>
constexpr auto across(const T& x, const T& y, const T& start_x, const T& start_y, const T& direction_x,
                      const T& direction_y) {
  return (y - start_y) * direction_x - (x - start_x) * direction_y;
}

/// Returns how far the foot lies beyond the ends of an edge; 0 between them.
template <class T>
constexpr auto overshoot(const T& along, const T& length, const T& zero) {
  return maximum(maximum(zero - along, along - length), zero);
}

/// Returns how far a coordinate lies beyond the half size of a box centred at 0; negative within the box.
template <class T>
constexpr auto beyond(const T& coordinate, const T& half) {
  return magnitude(coordinate) - half;
}

/// Returns |(x, y)|^2.
template <class T>
constexpr auto squared_length(const T& x, const T& y) {
  return x * x + y * y;
}

/// Returns a point's coordinate along a unit axis, and across it to its left.
template <class T>
constexpr auto turned_along(const T& x, const T& y, const T& axis_x, const T& axis_y) {
  return x * axis_x + y * axis_y;
}
template <class T>
constexpr auto turned_across(const T& x, const T& y, const T& axis_x, const T& axis_y) {
  return y * axis_x - x * axis_y;
}

/// The height of a ball's centre above the plane, with the bound of its error.
template <class N>
struct Height {
  N size;  ///< at least 1 and at least every coordinate of the centre in the frame: none is beyond sqrt(3) the widest
  N value, error;

  __attribute__((always_inline)) Height(const Vector3<N>& to_center, const Vector3<N>& normal, const N& plane_height)
      : value(height(normal, to_center, plane_height)) {
    const N widest = maximum(largest_component(to_center), constant<N>(1));
    size = widest + widest;
    error = constant<N>(bounds::kHeight * bounds::kUnit) * size;
  }
};

/// Returns the bound of the error of computed distances in the plane.
template <class N>
__attribute__((always_inline)) constexpr N distance_error(const N& size) {
  return constant<N>(bounds::kDistance * bounds::kUnit) * size;
}
/// Returns the square of the distance beyond which the foot is not on an edge.
template <class N>
__attribute__((always_inline)) constexpr N boundary_square(const N& distance_error) {
  const N near = constant<N>(bounds::kNear) * distance_error;
  return near * near;
}

/// Returns up to what squared distance boxes are looked at, if edges are up to this one.
template <class N>
__attribute__((always_inline)) constexpr N box_reach(const N& limit_sq) {
  return limit_sq * constant<N>(bounds::kBoxReach);
}

/// The disc in which a ball meets the plane. It tells which computed distances from its centre are certainly within it,
/// and which certainly beyond.
template <class N>
struct Disc {
  N inner;               ///< the smaller radius; unless it is positive, no distance is certainly within
  N inner_sq, outer_sq;  ///< the squares of both radii

  /// `low`, `high`: bounds of the distance between centre and plane, low not negative. `error`: that of distances.
  __attribute__((always_inline)) Disc(const N& radius, const N& low, const N& high, const N& error) {
    const N wide = constant<N>(bounds::kWide), narrow = constant<N>(bounds::kNarrow), zero = constant<N>(0);
    const auto half_chord = [&](const N& distance) {
      return square_root(maximum((radius - distance) * (radius + distance), zero));
    };
    const N outer = half_chord(low) + error;
    inner = half_chord(high) * narrow - error;
    outer_sq = outer * outer * wide;
    inner_sq = inner * inner;
  }
};

}  // namespace frame
}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

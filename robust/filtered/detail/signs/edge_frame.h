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

/// Returns |(x, y)|^2.
template <class T>
constexpr auto squared_length(const T& x, const T& y) {
  return x * x + y * y;
}

/// The foot as seen from an edge.
template <class N>
struct FootFromEdge {
  N along, across;  ///< from the edge's start along its direction, and to the left of its line
  N overshoot;      ///< beyond the ends; 0 between them
  N squared;        ///< the square of the distance

  __attribute__((always_inline)) FootFromEdge(const N& x, const N& y, const N& start_x, const N& start_y,
                                              const N& direction_x, const N& direction_y, const N& length)
      : along(frame::along(x, y, start_x, start_y, direction_x, direction_y)),
        across(frame::across(x, y, start_x, start_y, direction_x, direction_y)) {
    const N zero = constant<N>(0);
    overshoot = maximum(maximum(zero - along, along - length), zero);
    squared = squared_length(across, overshoot);
  }
};

/// Returns how far a coordinate lies beyond the half size of a box centred at 0; negative within the box.
template <class T>
constexpr auto beyond(const T& coordinate, const T& half) {
  return magnitude(coordinate) - half;
}

/// The foot as seen from a box with this centre, a unit axis, and half sizes along it and across it.
template <class N>
struct FootFromBox {
  N along, across;  ///< from the centre
  N beside, above;  ///< beyond the sides along the axis and across it; negative between them
  N squared;        ///< the square of the distance

  __attribute__((always_inline))
  FootFromBox(const N& x, const N& y, const N& center_x, const N& center_y, const N& axis_x, const N& axis_y,
              const N& half_along, const N& half_across)
      : along(frame::along(x, y, center_x, center_y, axis_x, axis_y)),
        across(frame::across(x, y, center_x, center_y, axis_x, axis_y)),
        beside(beyond(along, half_along)),
        above(beyond(across, half_across)) {
    const N zero = constant<N>(0);
    squared = squared_length(maximum(beside, zero), maximum(above, zero));
  }
};

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

// Heights in the caller's unit of length.

/// Returns the height of a centre above a plane from pairs of numbers: x and y, and z with any number, which the second
/// number of normal_z, 0, multiplies.
template <class Pair, class N>
__attribute__((always_inline)) constexpr N height_of_pairs(const Pair& xy, const Pair& z, const Pair& origin_xy,
                                                           const Pair& origin_z, const Pair& normal_xy,
                                                           const Pair& normal_z, const N& plane_height) {
  const Pair sum = (xy - origin_xy) * normal_xy + (z - origin_z) * normal_z;
  return (sum[0] + sum[1]) - plane_height;
}

/// Returns the part of the bound of such a height that grows with this length. The lengths of all parts are the largest
/// number of the ball, the largest coordinate of the origin, and the frame's unit.
template <class N>
__attribute__((always_inline)) constexpr N given_height_error(const N& length) {
  return constant<N>(bounds::kGivenHeight) * length;
}

// Distances in the plane.

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

/// Returns the square of the radius of the disc in which a ball meets a plane at this distance from its centre; it is
/// negative if it misses it.
template <class N>
__attribute__((always_inline)) constexpr N chord_square(const N& radius, const N& distance) {
  return (radius - distance) * (radius + distance);
}
/// Returns the radius of that disc; 0 if the ball misses the plane.
template <class N>
__attribute__((always_inline)) constexpr N half_chord(const N& radius, const N& distance) {
  return square_root(maximum(chord_square(radius, distance), constant<N>(0)));
}

/// Returns at least a distance, given its square.
template <class N>
__attribute__((always_inline)) constexpr N distance_at_least(const N& square) {
  return square_root(square) * constant<N>(bounds::kWide);
}
/// Returns at least the square of a sum of two distances.
template <class N>
__attribute__((always_inline)) constexpr N square_at_least(const N& a, const N& b) {
  const N sum = a + b;
  return sum * sum * constant<N>(bounds::kWide);
}

/// The disc in which a ball meets the plane. It tells which computed distances from its centre are certainly within it,
/// and which certainly beyond. The error adds at most error (2 radius + error) to the square of a distance up to the
/// ball's radius, so no root is needed.
template <class N>
struct Disc {
  N inner_sq, outer_sq;  ///< limits of squared distances; if inner_sq is negative, none is certainly within

  /// `low`, `high`: bounds of the distance between centre and plane, low not negative. `error`: that of distances.
  __attribute__((always_inline)) Disc(const N& radius, const N& low, const N& high, const N& error) {
    const N wide = constant<N>(bounds::kWide), narrow = constant<N>(bounds::kNarrow);
    const N more = error * (radius + radius + error) * wide;
    outer_sq = maximum(chord_square(radius, low), constant<N>(0)) * wide + more;
    inner_sq = chord_square(radius, high) * narrow - more;
  }
};

}  // namespace frame
}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

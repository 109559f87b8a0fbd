// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/motion/entry.h"

/// The events of a moving ball at edges and their starts, over lanes of doubles and over double-doubles alike.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// An edge as seen from a motion, along any orthonormal axes.
template <class Number>
struct MovingEdge {
  BoundedVector<Number> to_center;  ///< from the edge's start to the centre at time 0
  BoundedVector<Number> edge;
  BoundedVector<Number> velocity;  ///< from the centre at time 0 to that at time 1
  Bounded<Number> radius;          ///< exact

  /// Returns the quadratic of the distance from the edge's start.
  [[nodiscard]] TOUCHSTONE_INLINE EntryQuadratic<Number> from_start() const {
    const Bounded<Number> speed = dot(velocity, velocity), reach = square(radius);
    const auto turn = cross(to_center, velocity);
    return {speed, dot(to_center, velocity), dot(to_center, to_center) - reach, reach * speed - dot(turn, turn)};
  }
  /// Returns the quadratic of the distance from the edge's line.
  ///
  /// With m = e x w and n = e x d it is |m + t n|^2 - r^2 e.e. As m x n = (e.(w x d)) e, the discriminant is
  /// e.e (r^2 n.n - (e.(w x d))^2).
  [[nodiscard]] TOUCHSTONE_INLINE EntryQuadratic<Number> from_line() const {
    const Bounded<Number> length_squared = dot(edge, edge), reach = square(radius);
    const auto moment = cross(edge, to_center), change = cross(edge, velocity);
    const Bounded<Number> across = dot(change, change), apart = dot(edge, cross(to_center, velocity));
    return {across, dot(moment, change), dot(moment, moment) - reach * length_squared,
            length_squared * (reach * across - square(apart))};
  }
  /// Returns (c(t) - a).(b - a) for the edge from a to b.
  [[nodiscard]] TOUCHSTONE_INLINE Bounded<Number> along_at(const Bounded<Number>& time) const {
    return dot(to_center, edge) + time * dot(velocity, edge);
  }
};

/// Returns the event of the edge's start. The centre is farther from it than r at time 0.
template <class Number>
TOUCHSTONE_INLINE Entry<Number> start_event(const MovingEdge<Number>& moving) {
  return entry(moving.from_start(), true);
}

/// Returns the event of the edge's relative interior.
template <class Number>
TOUCHSTONE_INLINE Entry<Number> interior_event(const MovingEdge<Number>& moving) {
  Entry<Number> event = entry(moving.from_line(), false);
  const Bounded<Number> along = moving.along_at(event.time), left = dot(moving.edge, moving.edge) - along;
  event.none |= event.certain & (negative(along) | negative(left));
  event.certain &= positive(along) & positive(left);
  return event;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

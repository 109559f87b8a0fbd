// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "geometry/contact/answer.h"
#include "robust/filtered/detail/numbers/bounded.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"

/// The events of a moving ball at edges and their starts, over lanes of doubles and over double-doubles alike, and the
/// first of them.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// The time at which a moving centre comes within distance r of a plane, a line or a point, from the certain signs of
// numbers that carry their error.

/// Whether and when an event happens in (0, 1], one bit a lane.
template <class Number>
struct Entry {
  unsigned none, certain;  ///< it certainly does not happen, or certainly does; neither: not known
  Bounded<Number> time;    ///< where it certainly does

  /// The lanes in which the event may happen, but does not certainly.
  [[nodiscard]] unsigned unsure(unsigned lanes) const { return lanes & ~(none | certain); }
};

/// The coefficients of a t^2 + 2 b t + c, which is the squared distance at time t less r^2, times a positive factor;
/// and the discriminant b^2 - a c, computed so that it loses little where it is small.
template <class Number>
struct EntryQuadratic {
  Bounded<Number> a, b, c, discriminant;
};

/// Returns the smaller root, at which the distance falls to r.
///
/// It is in (0, 1] if and only if c > 0, b < 0, the discriminant is at least 0, and the value at 1 is at most 0 or the
/// vertex -b / a at most 1. A double root is never certain. If `starts_outside`, c is known to be positive.
template <class Number>
TOUCHSTONE_INLINE Entry<Number> entry(const EntryQuadratic<Number>& quadratic, bool starts_outside) {
  const auto& [a, b, c, discriminant] = quadratic;
  const Bounded<Number> slope_at_end = a + b, at_end = (slope_at_end + b) + c;
  const unsigned approaches = negative(b), meets = positive(discriminant);
  const unsigned ends_before = negative(slope_at_end) & positive(at_end);
  // a t^2 >= 0, also where a is so small that its sign is not certain.
  const unsigned stays_outside = positive(c) & positive((b + b) + c);
  const unsigned reaches = positive(slope_at_end) | negative(at_end);
  const unsigned outside = starts_outside ? ~0U : positive(c), inside = starts_outside ? 0U : negative(c);
  return {positive(b) | negative(discriminant) | inside | ends_before | stays_outside,
          approaches & meets & outside & reaches, quotient(c, root(discriminant) - b)};
}

/// The same for a plane, and the lanes in which the centre certainly stays farther from it than r, on one side.
template <class Number>
struct PlaneEntry {
  Entry<Number> entry;
  unsigned misses;
};

/// Returns when the height above a plane, h at time 0 and h + change at time 1, falls to `reach` in magnitude: all
/// three are multiplied by the length of the plane's normal. A point, whose reach is 0, then passes through the plane.
template <class Number>
TOUCHSTONE_INLINE PlaneEntry<Number> plane_entry(const Bounded<Number>& height, const Bounded<Number>& change,
                                                 const Bounded<Number>& reach) {
  const Bounded<Number> end = height + change, approach = height * change, departure = end * change;
  const Bounded<Number> outside = (height - reach) * (height + reach), outside_at_end = (end - reach) * (end + reach);
  const Bounded<Number> product = change * reach;
  const Bounded<Number> root{magnitude_of(product.value), product.error};
  const unsigned starts_outside = positive(outside), ends_outside = positive(outside_at_end);
  return {{positive(approach) | negative(outside) | (negative(departure) & ends_outside),
           negative(approach) & starts_outside & (positive(departure) | negative(outside_at_end)),
           quotient(outside, root - approach)},
          starts_outside & ends_outside & positive(height * end)};
}

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

/// Finds the first of several events, if it is certain which one that is. Times are doubles or double-doubles.
template <class Time>
class FirstCandidate {
 public:
  /// Adds an event that certainly happens, at this time up to this error.
  TOUCHSTONE_INLINE void add(const Feature& feature, const Time& time, double error) {
    // Covers the rounding of the error and of the two sums.
    const double wide = bounds::kWideError * error + kRounding * leading_part(time);
    const Time earliest = time - Time(wide), latest = time + Time(wide);
    if (before(latest, latest_)) {
      if (before(earliest_, earliest_of_others_)) earliest_of_others_ = earliest_;
      feature_ = feature, time_ = time, error_ = error, earliest_ = earliest, latest_ = latest;
    } else if (before(earliest, earliest_of_others_)) {
      earliest_of_others_ = earliest;
    }
  }
  /// Returns whether an event was added.
  [[nodiscard]] TOUCHSTONE_INLINE bool any() const { return before(latest_, Time(kNever)); }
  /// Returns whether one event is certainly before all others.
  [[nodiscard]] TOUCHSTONE_INLINE bool certain() const { return any() && before(latest_, earliest_of_others_); }
  /// Returns Yes if it is certain which event is first, or, if `any`, that one happens; No if it is certain that none
  /// does. `unsure`: whether events may happen that were not added.
  template <bool any>
  [[nodiscard]] TOUCHSTONE_INLINE FilterResult known(bool unsure) const {
    if (any && this->any()) return FilterResult::Yes;
    if (unsure) return FilterResult::Unsure;
    if (!this->any()) return FilterResult::No;
    return certain() ? FilterResult::Yes : FilterResult::Unsure;
  }
  [[nodiscard]] const Feature& feature() const { return feature_; }
  /// Returns the time of the first event, and its error.
  [[nodiscard]] const Time& time() const { return time_; }
  [[nodiscard]] double error() const { return error_; }
  /// Returns a time before which no added event happens.
  [[nodiscard]] TOUCHSTONE_INLINE double earliest() const {
    return leading_part(before(earliest_, earliest_of_others_) ? earliest_ : earliest_of_others_);
  }
  /// Returns a time until which the first event has certainly happened; at least 1 if none was added.
  [[nodiscard]] TOUCHSTONE_INLINE double latest() const { return leading_part(latest_); }

 private:
  static constexpr double kNever = 4;
  static constexpr double kRounding = std::is_same_v<Time, double> ? 0x1p-50 : 0x1p-100;
  static TOUCHSTONE_INLINE double leading_part(double time) { return time; }
  static TOUCHSTONE_INLINE double leading_part(const DoubleDouble& time) { return time.high; }
  static TOUCHSTONE_INLINE bool before(const Time& a, const Time& b) { return leading_part(a - b) < 0; }

  Feature feature_{Feature::Kind::Face, 0};
  Time time_ = kNever;
  double error_ = 0;
  Time earliest_ = kNever, latest_ = kNever, earliest_of_others_ = kNever;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

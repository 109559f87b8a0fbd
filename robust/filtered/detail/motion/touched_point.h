// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "geometry/contact/first_contact.h"
#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/signs/closest_point.h"

/// The time and the point of an event, correctly rounded, in double-doubles with a rounding test.
///
/// `Doubles` are a motion and a polygon or triangle in double-doubles: `moving(i)`, `normal()` and its
/// `normal_length()`, `center(axis)`, `vertex(i, axis)`, `rounded_vertex(i, axis)`, `flat(axis)`, whether all vertices
/// have the same coordinate, `lifts(axis)`, and `unscaled(length)`, which converts to the caller's unit of length.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The unit of times.
struct Unitless {
  [[nodiscard]] static double unscaled(double time) { return time; }
};

/// Returns when and whether the centre's distance from the supporting plane becomes r.
template <class Doubles>
PlaneEntry<DoubleDouble> face_entry(const Doubles& doubles) {
  const MovingEdge<DoubleDouble> edge = doubles.moving(0);
  const auto& normal = doubles.normal();
  return plane_entry(dot(normal, edge.to_center), dot(normal, edge.velocity), edge.radius * doubles.normal_length());
}

/// Returns the time of a feature's event, which certainly happens.
template <class Doubles>
Bounded<DoubleDouble> event_time(const Doubles& doubles, const Feature& feature) {
  switch (feature.kind) {
    case Feature::Kind::Face: return face_entry(doubles).entry.time;
    case Feature::Kind::Edge: return entry(doubles.moving(feature.index).from_line(), false).time;
    case Feature::Kind::Vertex: break;
  }
  return entry(doubles.moving(feature.index).from_start(), true).time;
}

/// Computes the first contact from a feature that is certainly touched first, at a simple root or, for a point, at the
/// face's plane.
template <class Doubles>
class TouchedPoint {
 public:
  TouchedPoint(const Doubles& doubles, const Feature& feature, const Bounded<DoubleDouble>& time)
      : doubles_(doubles), feature_(feature), moving_(doubles.moving(feature.index)), time_(time) {
    if (feature.kind == Feature::Kind::Edge)
      multiple_ = quotient(moving_.along_at(time_), dot(moving_.edge, moving_.edge));
    if (feature.kind == Feature::Kind::Face && moving_.radius.value.high > 0) {
      const auto& normal = doubles.normal();
      const auto height = dot(normal, moving_.to_center);
      multiple_ = quotient(moving_.radius, doubles.normal_length());
      if (height.value.high > 0) multiple_.value = -multiple_.value;
    }
  }

  /// Returns the first contact, if the rounding of time and point is certain.
  [[nodiscard]] std::optional<FirstContact> rounded_contact() const {
    const auto time = not_too_small(time_, Unitless());
    const auto x = coordinate(0), y = coordinate(1), z = coordinate(2);
    if (!time || !x || !y || !z) return std::nullopt;
    const bool passes = feature_.kind == Feature::Kind::Face && !(moving_.radius.value.high > 0);
    return FirstContact{FirstContactKind::Way, *time, passes, feature_, {*x, *y, *z}};
  }

 private:
  /// Returns the coordinate as the nearest double; zero as +0.
  [[nodiscard]] std::optional<double> coordinate(int axis) const {
    const auto& doubles = doubles_;
    if (feature_.kind == Feature::Kind::Vertex || (feature_.kind == Feature::Kind::Face && doubles.flat(axis)) ||
        (feature_.kind == Feature::Kind::Edge && !doubles.lifts(axis) && moving_.edge.value[axis].high == 0))  // exact
      return doubles.rounded_vertex(feature_.index, axis);
    if (feature_.kind == Feature::Kind::Edge)
      return not_too_small(doubles.vertex(feature_.index, axis) + multiple_ * component(moving_.edge, axis), doubles);
    Bounded<DoubleDouble> value =
        Bounded<DoubleDouble>{doubles.center(axis), 0} + time_ * component(moving_.velocity, axis);
    if (moving_.radius.value.high > 0) value = value + multiple_ * component(doubles.normal(), axis);
    return not_too_small(value, doubles);
  }
  /// Returns the nearest double. Steps from exact numbers may underflow, of which their errors know nothing; from
  /// kSmallestResult on that does not matter.
  template <class Unit>
  static std::optional<double> not_too_small(const Bounded<DoubleDouble>& number, const Unit& unit) {
    if (!(std::abs(number.value.high) >= kSmallestResult)) return std::nullopt;
    return rounded(Enclosed{number.value, bounds::kWideError * number.error}, unit);
  }
  static Bounded<DoubleDouble> component(const BoundedVector<DoubleDouble>& vector, int axis) {
    return {vector.value[axis], vector.error};
  }

  const Doubles& doubles_;
  const Feature feature_;
  const MovingEdge<DoubleDouble> moving_;
  const Bounded<DoubleDouble> time_;
  Bounded<DoubleDouble> multiple_{};
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

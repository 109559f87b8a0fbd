// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "geometry/contact/first_contact.h"
#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/signs/closest_point.h"

/// The time, the point and the contact normal of an event, correctly rounded, in double-doubles with a rounding test.
///
/// `Doubles` are a motion and a polygon or triangle in double-doubles: `moving(i)`, `normal()` and its
/// `normal_length()`, `no_normal(axis)`, whether a component of it is certainly zero, `center(axis)`, `vertex(i,
/// axis)`, `rounded_vertex(i, axis)`, `flat(axis)`, whether all vertices have the same coordinate, `lifts(axis)`, and
/// `unscaled(length)`, which converts to the caller's unit of length.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The unit of times and of components of normals.
struct Unitless {
  [[nodiscard]] static double unscaled(double number) { return number; }
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
    if (feature.kind == Feature::Kind::Face) {
      const bool in_front = dot(doubles.normal(), moving_.to_center).value.high > 0;
      inverse_ = quotient(kOne, doubles.normal_length());
      if (!in_front) inverse_.value = -inverse_.value;
      multiple_ = moving_.radius * inverse_;
    } else if (moving_.radius.value.high >= kSmallestResult) {
      inverse_ = quotient(kOne, moving_.radius);
    }
  }

  /// Returns the first contact, if the rounding of time, point and normal is certain.
  [[nodiscard]] std::optional<FirstContact> rounded_contact() const {
    const auto time = not_too_small(time_, Unitless());
    const auto x = coordinate(0), y = coordinate(1), z = coordinate(2);
    if (!time || !x || !y || !z) return std::nullopt;
    const auto normal_x = normal(0), normal_y = normal(1), normal_z = normal(2);
    if (!normal_x || !normal_y || !normal_z) return std::nullopt;
    const bool passes = feature_.kind == Feature::Kind::Face && !(moving_.radius.value.high > 0);
    return FirstContact{
        FirstContactKind::Way, *time, passes, feature_, {*x, *y, *z}, {*normal_x, *normal_y, *normal_z}, 0};
  }

 private:
  static constexpr Bounded<DoubleDouble> kOne{DoubleDouble(1.0), 0};

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
    if (moving_.radius.value.high > 0) value = value - multiple_ * component(doubles.normal(), axis);
    return not_too_small(value, doubles);
  }
  /// Returns a component of the normal, which is (c(t) - p) / r for the touched point p, as the nearest double; zero as
  /// +0.
  [[nodiscard]] std::optional<double> normal(int axis) const {
    if (feature_.kind == Feature::Kind::Face) {
      if (doubles_.no_normal(axis)) return 0.0;
      return not_too_small(component(doubles_.normal(), axis) * inverse_, Unitless());
    }
    if (!(moving_.radius.value.high >= kSmallestResult)) return std::nullopt;
    if (moving_.to_center.error == 0 && moving_.edge.error == 0 && zero_away(axis)) return 0.0;
    auto away = component(moving_.to_center, axis) + time_ * component(moving_.velocity, axis);
    if (feature_.kind == Feature::Kind::Edge) away = away - multiple_ * component(moving_.edge, axis);
    return not_too_small(away * inverse_, Unitless());
  }
  /// Returns whether c(t) - p has a component of zero at all times, for exact vectors.
  [[nodiscard]] bool zero_away(int axis) const {
    const auto &from = moving_.to_center.value, &velocity = moving_.velocity.value, &edge = moving_.edge.value;
    if (feature_.kind == Feature::Kind::Vertex || edge[axis].high == 0)                 // exact
      return from[axis].high == 0 && velocity[axis].high == 0;                          // exact
    if (edge[(axis + 1) % 3].high == 0 && edge[(axis + 2) % 3].high == 0) return true;  // exact
    return zero_across(from, edge, axis) && zero_across(velocity, edge, axis);
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
  Bounded<DoubleDouble> multiple_{};  ///< of the edge, from its start; of the normal, from the touched point
  Bounded<DoubleDouble> inverse_{};   ///< 1 / r; of the normal's length, negative for one that points away
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

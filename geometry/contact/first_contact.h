// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string_view>

#include "../same_number.h"
#include "answer.h"

namespace touchstone {

/// When a moving ball first touches a polygon: at t = 0, at a later time t <= 1, or never on its way.
enum class FirstContactKind { Start, Way, None };

/// The first contact of a moving ball with a polygon, as the contract defines it.
///
/// The members after `kind` have meaning as far as there is a contact; without one they have the values below. Two
/// first contacts are equal if all their members are, numbers compared by value.
struct FirstContact {
  FirstContactKind kind = FirstContactKind::None;            ///< when
  double time = std::numeric_limits<double>::infinity();     ///< the least t at which the ball touches: 0 for Start
  bool momentary = false;                                    ///< for Way: the ball leaves again at once
  Feature feature = {Feature::Kind::Face, 0};                ///< contains the closest point at that time
  Eigen::Vector3d point = Eigen::Vector3d::Zero();           ///< the closest point at that time
  Eigen::Vector3d contact_normal = Eigen::Vector3d::Zero();  ///< of length 1, from there to the centre at that time
  double depth = 0;                                          ///< for Start: the radius less the distance

  /// Returns whether the ball touches at any time.
  [[nodiscard]] bool contact() const { return kind != FirstContactKind::None; }
  friend bool operator==(const FirstContact& a, const FirstContact& b) {
    return a.kind == b.kind && same_number(a.time, b.time) && a.momentary == b.momentary && a.feature == b.feature &&
           same_point(a.point, b.point) && same_point(a.contact_normal, b.contact_normal) &&
           same_number(a.depth, b.depth);
  }
};

/// Returns the word of the contract: `start`, `way` or `none`.
[[nodiscard]] std::string_view to_string(FirstContactKind kind);

}  // namespace touchstone

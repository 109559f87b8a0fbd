// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "ball.h"
#include "rejection.h"

namespace touchstone {

/// A ball whose centre moves along a segment: at time t in [0, 1] it is c(t) = c + t (c' - c).
///
/// The points that the ball covers on its way are those of the capsule around the segment from c to c'. A ball at rest,
/// c' = c, is a motion, too. All numbers are exact real numbers, in the unit of length of the polygon. Requires a valid
/// ball and a finite end; `find_fault` checks this. The contact functions do not check it again, but debug builds
/// assert it.
struct Motion {
  Motion() = default;
  /// Makes a motion from a ball and the end of its centre's way. Not an aggregate: {centre, radius} is a ball only.
  Motion(const Ball& start, const Eigen::Vector3d& end) : ball(start), to(end) {}

  /// Returns whether c' = c. Call it in the default state of the floating-point unit.
  [[nodiscard]] bool at_rest() const { return to == ball.center; }  // exact

  Ball ball;           ///< at t = 0, with centre c
  Eigen::Vector3d to;  ///< c', the centre at t = 1
};

/// Returns why the motion is invalid, in the contract's order of codes (of two numbers that are not finite, the ball's
/// comes first), or nothing if it is valid.
[[nodiscard]] std::optional<Rejection> find_fault(const Motion& motion);

}  // namespace touchstone

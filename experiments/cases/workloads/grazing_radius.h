// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "geometry/shapes/motion.h"

namespace touchstone::workloads {

/// Returns the motion with another radius.
[[nodiscard]] inline Motion with_radius(const Motion& motion, double radius) {
  return {{motion.ball.center, radius}, motion.to};
}

/// Returns the least double with which the ball touches anything on its way, whatever its radius, by bisection among
/// the doubles: a ball that touches still does if it is larger. Requires a correct `touches`, true of the largest
/// double. Cost: 64 questions.
[[nodiscard]] double grazing_radius(const Motion& motion, const std::function<bool(const Motion&)>& touches);

/// Returns the same, given an estimate that is not negative. Cost: 2 questions if the estimate is correct, and 4 for
/// each factor of 2 in the number of doubles by which it is off.
[[nodiscard]] double grazing_radius(const Motion& motion, const std::function<bool(const Motion&)>& touches,
                                    double estimate);

}  // namespace touchstone::workloads

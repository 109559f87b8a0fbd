// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "robust/exact/exact.h"

namespace touchstone::exact {

/// The feature nearest to a ball's centre, and the point on it, rounded as in Answer.
struct Touched {
  Feature nearest;
  Eigen::Vector3d point;
};

/// Returns what the ball touches; nothing if it is separate. Requires the floating-point state of FloatingPointState.
[[nodiscard]] std::optional<Touched> touched(const Ball& ball, const PreparedPolygon& polygon);

}  // namespace touchstone::exact

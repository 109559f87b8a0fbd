// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "../floating_point.h"
#include "rejection.h"

namespace touchstone {

/// The closed ball of the points at distance <= radius from the centre. A ball of radius 0 is a point.
///
/// Centre and radius are exact real numbers, in the same unit of length as the polygon. Requires finite coordinates and
/// a finite radius >= 0; `find_fault` checks this. The contact functions do not check it again, but debug builds assert
/// it.
struct Ball {
  Eigen::Vector3d center;  ///< c
  double radius;           ///< r
};

/// Returns why the ball is invalid (`not-finite` before `negative-radius`), or nothing if it is valid. A radius of -0
/// is 0.
[[nodiscard]] std::optional<Rejection> find_fault(const Ball& ball);

}  // namespace touchstone

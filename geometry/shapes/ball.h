// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "../floating_point.h"
#include "rejection.h"

namespace touchstone {

/// The closed ball of the points at distance <= radius from the centre; radius 0 is a point.
///
/// Centre and radius are exact real numbers in one unit of length, that of the polygon asked about. Requires finite
/// coordinates and a finite radius >= 0: what `find_fault` accepts. The contact functions do not look again; a debug
/// build asserts it (geometry/detail/required.h).
struct Ball {
  Eigen::Vector3d center;  ///< c
  double radius;           ///< r
};

/// The reason why a ball is none (`not-finite` before `negative-radius`), if there is one. A radius of -0 is 0.
[[nodiscard]] std::optional<Rejection> find_fault(const Ball& ball);

}  // namespace touchstone

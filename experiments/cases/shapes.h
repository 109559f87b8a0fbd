// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::cases {

/// A valid ball, at a place or moving, and a valid polygon: input for every method.
struct Shapes {
  Ball ball;
  Polygon polygon;
  std::optional<Eigen::Vector3d> to{};  ///< the end of the centre's way, if the ball moves

  [[nodiscard]] std::optional<Motion> motion() const { return to ? std::optional(Motion{ball, *to}) : std::nullopt; }
};

}  // namespace touchstone::cases

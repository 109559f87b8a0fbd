// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/ball.h"

#include <cmath>

#include "geometry/detail/floating_point_state.h"

namespace touchstone {

std::optional<Rejection> find_fault(const Ball& ball) {
  const FloatingPointState nearest;
  if (!ball.center.allFinite()) return Rejection{RejectionCode::NotFinite, "the ball's center is not finite"};
  if (!std::isfinite(ball.radius)) return Rejection{RejectionCode::NotFinite, "the ball's radius is not finite"};
  if (ball.radius < 0) return Rejection{RejectionCode::NegativeRadius, "the ball's radius is negative"};
  return std::nullopt;
}

}  // namespace touchstone

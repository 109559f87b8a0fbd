// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/rejection.h"

#include <cmath>

#include "geometry/detail/floating_point_state.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"

namespace touchstone {

std::string_view to_string(RejectionCode code) {
  switch (code) {
    case RejectionCode::MalformedCase: return "malformed-case";
    case RejectionCode::NotFinite: return "not-finite";
    case RejectionCode::NegativeRadius: return "negative-radius";
    case RejectionCode::TooFewVertices: return "too-few-vertices";
    case RejectionCode::RepeatedVertex: return "repeated-vertex";
    case RejectionCode::ZeroNormal: return "zero-normal";
    case RejectionCode::LoopMeetsItself: return "loop-meets-itself";
    case RejectionCode::LoopsMeet: return "loops-meet";
    case RejectionCode::HoleOutside: return "hole-outside";
  }
  return {};
}

std::optional<Rejection> find_fault(const Ball& ball) {
  const FloatingPointState nearest;
  if (!ball.center.allFinite()) return Rejection{RejectionCode::NotFinite, "the ball's center is not finite"};
  if (!std::isfinite(ball.radius)) return Rejection{RejectionCode::NotFinite, "the ball's radius is not finite"};
  if (ball.radius < 0) return Rejection{RejectionCode::NegativeRadius, "the ball's radius is negative"};
  return std::nullopt;
}

std::optional<Rejection> find_fault(const Motion& motion) {
  auto fault = find_fault(motion.ball);
  if (fault && fault->code == RejectionCode::NotFinite) return fault;
  const FloatingPointState nearest;
  if (!motion.to.allFinite()) return Rejection{RejectionCode::NotFinite, "motion.to is not finite"};
  return fault;
}

}  // namespace touchstone

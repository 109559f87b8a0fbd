// SPDX-License-Identifier: Apache-2.0
#include "geometry/shapes/motion.h"

#include "geometry/detail/floating_point_state.h"

namespace touchstone {

std::optional<Rejection> find_fault(const Motion& motion) {
  auto fault = find_fault(motion.ball);
  if (fault && fault->code == RejectionCode::NotFinite) return fault;
  const FloatingPointState nearest;
  if (!motion.to.allFinite()) return Rejection{RejectionCode::NotFinite, "motion.to is not finite"};
  return fault;
}

}  // namespace touchstone

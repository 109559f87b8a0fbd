// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/workloads/placement.h"
#include "experiments/workloads/workload.h"
#include "geometry/shapes/ball.h"

namespace touchstone::workloads {

/// The ball of sample `index`, where `workload.ball` says. The centre does not depend on `workload.doubles`; only the
/// radius of a Near* or LatticeTangent ball does (no less than 0).
///
/// Heights above the plane are zero, ample or small: down to 2^-30 of the lattice. Near* balls are checked by
/// `exact::answer` (nearest feature of that kind, distance > 0), LatticeTangent ones too (touching), and drawn again
/// otherwise. Throws std::invalid_argument if none was found, or a tangent ball is asked for in a rotated frame.
[[nodiscard]] Ball draw_ball(const PlacedOutline& placed, const Workload& workload, std::uint64_t seed,
                             std::uint64_t index);

}  // namespace touchstone::workloads

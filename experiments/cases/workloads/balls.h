// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/ball.h"

namespace touchstone::workloads {

/// Draws the ball of sample `index` at the place `workload.ball`. The centre does not depend on `workload.doubles`;
/// only the radius of a Near* or LatticeTangent ball does (it stays at least 0).
///
/// Heights above the plane are zero, ample or small: down to 2^-30 of the size of the lattice. `exact::answer` checks
/// Near* balls (nearest feature of that kind, distance > 0) and LatticeTangent balls (touching); those that fail are
/// drawn again. Throws std::invalid_argument if no ball was found, or for a tangent ball in a rotated frame.
[[nodiscard]] Ball draw_ball(const PlacedOutline& placed, const Workload& workload, std::uint64_t seed,
                             std::uint64_t index);

}  // namespace touchstone::workloads

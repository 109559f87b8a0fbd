// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/motion.h"

namespace touchstone::workloads {

/// Draws the motion of sample `index`, given its ball at the place `workload.ball`, on the way `workload.way`, which is
/// not Static.
///
/// A way has about the length of the outline. In a lattice frame with a tangent ball every number is exact, so that the
/// ball grazes, slides, starts or ends in exact contact. Otherwise a threshold of the radius is one of the way, too: a
/// ball that passes at distance d, across except for an angle of e, comes as near as d cos(e).
[[nodiscard]] Motion draw_motion(const Ball& ball, const PlacedOutline& placed, const Workload& workload,
                                 std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::workloads

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {

/// Returns when what moves on a run is in a virtual object, by the stop at which it comes in.
///
/// What moves are the surfaces of the arm and of held material, as triangles that cover them, and the sphere; with
/// `sphere_alone` the sphere only. A box, sphere or capsule is solid. What touches is in.
///
/// Guarantee: at an angle of the run that no trigger names, nothing is in: certified between the stops, too. The
/// converse does not hold: a trigger may be early by what the mover moves in a 64th of a step, and a pass may be a miss
/// by as much. Method: distances at the stops, halving between them with the greatest way of any point of a part. Cost:
/// 10 to 50 ms per object for the default cell.
[[nodiscard]] std::vector<Trigger> zone_triggers(const Workcell& workcell, const Process& process, bool sphere_alone);

/// Ends a process at the last stop before something comes into a virtual object that stops the robot, if anything does.
/// Requires its triggers, and drops those that come later.
void stop_at_zones(const Workcell& workcell, Process& process);

}  // namespace touchstone::cell

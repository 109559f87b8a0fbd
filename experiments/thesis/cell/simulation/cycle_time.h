// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {

/// Returns how many seconds a move takes if every joint that turns keeps to its greatest speed: a joint that makes up
/// for another turns, too. Empty if the speed of one of them is unknown. Acceleration is left out, so a real robot
/// takes longer.
[[nodiscard]] std::optional<double> seconds(const Arm& arm, Moved joint, double degrees);

/// Returns when the arm is at each stop, in seconds since the first one; empty if a speed is unknown. The last time is
/// the cycle time, without gripping and milling.
[[nodiscard]] std::vector<double> times_of(const Arm& arm, const Process& process);

/// Returns the joint that moves from one stop to the next, and by how much. Requires stops that differ in one joint, or
/// in none: then the base moves by 0.
struct StepOfJoint {
  Moved joint;
  double degrees;
};
[[nodiscard]] StepOfJoint step_between(const Stop& from, const Stop& to);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/thesis/cell/simulation/workcell.h"

namespace touchstone::cell {

/// Says why the gripper would not hold material at a pose in the flange's frame: on which side no finger is within the
/// play of Gripper::Hold. Empty if it would, or if the cell has no such condition.
[[nodiscard]] std::string why_not_held(const Workcell& workcell, const Pose& in_flange);

/// Names the part of the gripper that material at a pose in the flange's frame touches; empty if none does.
[[nodiscard]] std::string met_by_gripper(const Workcell& workcell, const Pose& in_flange);

}  // namespace touchstone::cell

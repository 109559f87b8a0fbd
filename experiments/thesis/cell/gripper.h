// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchstone::cell {

/// Returns cases of a cell's run, one per line, as experiments/judge/corpus/given/gripper.jsonl holds them. For every
/// face of the obstacles and of the material that the gripper's sphere comes near, takes the stop nearest to the face,
/// with the sphere's own radius; also with the double nearest to the distance and its neighbours, if a witness is wrong
/// there. Not part of `make`, since libraries differ in the last bits of sines and cosines. Throws what reading the
/// cell and building its model throw.
[[nodiscard]] std::string gripper_cases(const std::string& cell_file);

}  // namespace touchstone::cell

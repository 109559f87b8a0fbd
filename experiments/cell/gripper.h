// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace touchstone::cell {

/// Cases of a cell's run, a line each, as experiments/judge/corpus/given/gripper.jsonl holds them: of every face of its
/// obstacles and of the material that the gripper's sphere comes near to, the stop at which it comes nearest, with the
/// sphere's own radius; and with the double nearest to the distance, and those beside it, where a witness is wrong
/// then. Not part of `make`, since libraries differ in the last bits of sines and cosines. Throws what reading the cell
/// and building its model throw.
[[nodiscard]] std::string gripper_cases(const std::string& cell_file);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "experiments/cell/simulation/contest.h"

namespace touchstone::cell {

/// What `touchstone cell run` prints: the moves, what was tested and what was skipped, the methods, how it ended.
[[nodiscard]] std::string summary(const Workcell& workcell, const Process& process, const Contest& contest);

/// Writes what a run gave:
///  - moves.csv: a line a move, with what was certified of its contact;
///  - trajectory.csv and trajectory.json: every stop: phase, joint that moves, all joints' angles, the sphere, what it
///    touches, where the material is;
///  - methods.csv: a line a method;
///  - disagreements.jsonl: cases that `touchstone judge` reads, expected answers from `exact`; `most` at most.
/// Throws std::runtime_error where one cannot be written.
void write_run(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
               const Contest& contest, std::size_t most = 1000);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/thesis/cell/simulation/method_comparison.h"
#include "experiments/thesis/cell/simulation/separation.h"

namespace touchstone::cell {

/// Returns the output of `touchstone cell run`: the moves, the numbers of tests made, the least distances, the
/// methods, and how it ended.
[[nodiscard]] std::string summary(const Workcell& workcell, const Process& process, const Separation& separation,
                                  const MethodComparison& comparison);

/// Writes the results of a run:
///  - moves.csv: one line per move, with its certified contact;
///  - trajectory.csv: every stop: phase, joint that moves, all joints' angles, the sphere, the face that it touches,
///    the place of the material;
///  - separation.csv: the least distance of arm, held material and sphere from every element;
///  - triggers.csv: what comes into virtual objects;
///  - methods.csv: one line per method;
///  - near.csv: how near the questions come to contact;
///  - disagreements.jsonl: at most `most` cases for `touchstone judge`, with expected answers from `exact`.
/// Throws std::runtime_error if a file cannot be written.
void write_run(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
               const Separation& separation, const MethodComparison& comparison, std::size_t most = 1000);

[[nodiscard]] std::vector<program::TableDescription> run_tables();

}  // namespace touchstone::cell

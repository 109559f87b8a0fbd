// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "experiments/program/table.h"
#include "experiments/thesis/cell/simulation/process.h"
#include "experiments/thesis/cell/simulation/separation.h"

namespace touchstone::cell {

/// Returns the least distances as `touchstone cell run` prints them, and the cycle time.
[[nodiscard]] std::string separation_text(const Workcell& workcell, const Process& process,
                                          const Separation& separation);

/// Writes separation.csv, a line for each mover and element. Throws std::runtime_error if it cannot be written.
void write_separation(const std::filesystem::path& folder, const Workcell& workcell, const Process& process,
                      const Separation& separation);

[[nodiscard]] program::TableDescription separation_table();

/// Returns what came into virtual objects, one line each; nothing if the cell has none.
[[nodiscard]] std::string triggers_text(const Workcell& workcell, const Process& process);

/// Writes triggers.csv: when what came into which virtual object.
void write_triggers(const std::filesystem::path& folder, const Workcell& workcell, const Process& process);

[[nodiscard]] program::TableDescription triggers_table();

}  // namespace touchstone::cell

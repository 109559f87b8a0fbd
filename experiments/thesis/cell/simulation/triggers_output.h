// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "experiments/run/table.h"
#include "experiments/thesis/cell/simulation/process.h"

namespace touchstone::cell {

/// Returns what came into virtual objects, one line each; nothing if the cell has none.
[[nodiscard]] std::string triggers_text(const Workcell& workcell, const Process& process);

/// Writes triggers.csv: when what came into which virtual object.
void write_triggers(const std::filesystem::path& folder, const Workcell& workcell, const Process& process);

[[nodiscard]] run::TableDescription triggers_table();

}  // namespace touchstone::cell

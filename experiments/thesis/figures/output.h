// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/thesis/figures/entry.h"
#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

// Each throws std::runtime_error, which names the file, if one cannot be written. tables() says what the tables hold.

/// Writes entries.csv and numbers.csv.
void write_entries(const std::filesystem::path& folder, const std::vector<Entry>& entries);

/// Writes the data of the pictures: the other tables; drawing.json with the cell's parts, their poses at every moment
/// of both cases, the floor plan and the outlines; and in models/ the model files of Axis1, of the gripper and of the
/// machine's bottom part.
void write_data(const std::filesystem::path& folder, const Study& study);

[[nodiscard]] std::vector<program::TableDescription> tables();

/// Returns for the terminal the number of entries with each status, and every stated number that ours differs from.
[[nodiscard]] std::string table(const std::vector<Entry>& entries);

}  // namespace touchstone::figures

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/program/table.h"
#include "experiments/thesis/cell/kinematics/layout_study.h"

namespace touchstone::kinematics {

/// Writes the tables of the study; layout_tables() says what they hold. Throws std::runtime_error, which names the
/// file, if one cannot be written.
void write_layout(const std::filesystem::path& folder, const LayoutStudy& study);

[[nodiscard]] std::vector<program::TableDescription> layout_tables();

/// Returns the moves of both cases and a line on the predictions, for the terminal.
[[nodiscard]] std::string layout_table(const LayoutStudy& study);

}  // namespace touchstone::kinematics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/model.h"

namespace touchstone::cell {

/// Returns a summary for the terminal: parts with their faces, joints, stations, and where values come from.
[[nodiscard]] std::string summary(const Cell& cell, const std::vector<ModelPart>& parts);

/// Writes faces.csv: one line per face. Throws std::runtime_error if it cannot be written.
void write_faces(const std::filesystem::path& folder, const std::vector<ModelPart>& parts);
[[nodiscard]] std::vector<run::TableDescription> show_tables();

/// Writes model files: one for all parts of a link, and one for every other part. Returns their number. Throws as
/// above.
std::size_t write_models(const std::filesystem::path& folder, const std::vector<ModelPart>& parts);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/cell/model/cell.h"
#include "experiments/cell/model/model.h"

namespace touchstone::cell {

/// For the terminal: parts with their faces, joints, stations, and where values come from.
[[nodiscard]] std::string summary(const Cell& cell, const std::vector<ModelPart>& parts);

/// faces.csv: a line a face. Throws std::runtime_error where it cannot be written.
void write_faces(const std::filesystem::path& folder, const std::vector<ModelPart>& parts);

/// Model files: all parts of a link in one, every other part in one of its own. Returns how many. Throws as above.
std::size_t write_models(const std::filesystem::path& folder, const std::vector<ModelPart>& parts);

}  // namespace touchstone::cell

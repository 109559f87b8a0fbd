// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/merging/study.h"

namespace touchstone::merging {

// Each writes a table: tables() says what it holds. All but the times have the same bytes for the same settings and
// meshes. Each throws std::runtime_error, which names the file, if it cannot be written.

void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results);

[[nodiscard]] std::vector<run::TableDescription> tables();

/// Returns the table for the terminal: one row per mesh and the sum; if scenes were compared, their costs; and a
/// legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<MeshResult>& results);

}  // namespace touchstone::merging

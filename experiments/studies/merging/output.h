// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/merging/study.h"

namespace touchstone::merging {

/// Writes merge.csv: one line per mesh with the result of merging and the number of differing answers; the same bytes
/// for the same settings and meshes. Throws std::runtime_error if it cannot be written.
void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
/// Writes polygons.csv: one line per polygon, by its lowest face: the number of faces of the mesh that it consists of,
/// and their distance from its plane. Throws as above.
void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
/// Writes merge-times.csv: one line per mesh and kind of scene: faces, memory and times. Throws as above.
void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results);

/// Returns the table for the terminal: one row per mesh and the sum; if scenes were compared, their costs; and a
/// legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<MeshResult>& results);

}  // namespace touchstone::merging

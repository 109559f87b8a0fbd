// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/studies/merging/study.h"

namespace touchstone::merging {

/// merge.csv: a line a mesh, what merging made of it and how many answers differ; the same bytes for the same settings
/// and meshes. Throws std::runtime_error where it cannot be written.
void write_counts(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
/// polygons.csv: a line a polygon, by its lowest face: of how many faces of the mesh it is made, and how far these are
/// off its plane. Throws as above.
void write_polygons(const std::filesystem::path& folder, const std::vector<MeshResult>& results);
/// merge-times.csv: a line a mesh and kind of scene: faces, memory and times. Throws as above.
void write_times(const std::filesystem::path& folder, const std::vector<MeshResult>& results);

/// For the terminal: a row a mesh and the sum; where scenes were compared, their costs; and a legend.
[[nodiscard]] std::string table(const Settings& settings, const std::vector<MeshResult>& results);

}  // namespace touchstone::merging

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/run/table.h"
#include "experiments/studies/bench_scenes/study.h"

namespace touchstone::bench_scenes {

/// Returns the build times and memory of one scene.
[[nodiscard]] std::string builds_table(const SceneResult& result);
/// Returns the costs of poses of one scene; nothing if they were not measured.
[[nodiscard]] std::string poses_table(const SceneResult& result);
/// Returns how the exact library's time grew.
[[nodiscard]] std::string growth_table(const std::vector<Growth>& growths, const std::string& library);
/// Returns every goal: ratios, builds, memory, poses, growth; how many were met, and which were not.
[[nodiscard]] std::string scene_goals(const std::vector<SceneResult>& results, const std::string& library);
/// Returns the legend: the comparisons, and the meaning of the columns.
[[nodiscard]] std::string scene_legend();

[[nodiscard]] nlohmann::ordered_json json(const std::vector<SceneResult>& results);

/// Writes all tables. Throws std::runtime_error, which names the file, if one cannot be written.
void write_scene_tables(const std::filesystem::path& folder, const std::vector<SceneResult>& results);
[[nodiscard]] std::vector<run::TableDescription> tables();

}  // namespace touchstone::bench_scenes

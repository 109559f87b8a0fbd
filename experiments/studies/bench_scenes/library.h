// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/methods/engines/engines.h"

namespace touchstone::bench_scenes {

using methods::BuiltScene;
using methods::Library;
using methods::Mesh;

// One a file. Where a library answers by boxes alone, the triangles are asked by `fast::contact`, plain doubles.
[[nodiscard]] Library touchstone_library();
[[nodiscard]] Library boost_rtree_library();
[[nodiscard]] Library cgal_aabb_tree_library();
// What textbooks name (broad_phases/): conservative candidates, then `fast::contact`; they do not know `nearest`.
[[nodiscard]] Library grid_library();
[[nodiscard]] Library octree_library();
[[nodiscard]] Library kd_tree_library();
[[nodiscard]] Library sphere_tree_library();
[[nodiscard]] Library kdop_tree_library();

/// Returns the libraries that this program was built with, the exact one first; among them the engines whose adapters
/// are those of the methods.
[[nodiscard]] std::vector<Library> all_libraries();
/// Returns the libraries that it was built without, and the Debian package that each needs.
[[nodiscard]] std::vector<std::string> absent_libraries();

}  // namespace touchstone::bench_scenes

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "experiments/studies/bench_scenes/study.h"

namespace touchstone::bench {

struct SceneOptions {
  SceneSettings settings;
  std::size_t most_triangles = 1'000'000;
  std::string meshes;  ///< a folder; empty: no real meshes
  std::string output = "results/bench-scene";
  bool force = false, no_pictures = false;
};

/// `touchstone bench --scene`: measures, prints, writes and draws everything; returns the exit status: 1 where the
/// exact scene and brute force differ.
int measure_scenes(const SceneOptions& options);

}  // namespace touchstone::bench

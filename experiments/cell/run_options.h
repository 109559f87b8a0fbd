// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/cell/browser/recording.h"
#include "experiments/harness/command.h"

namespace touchstone::cell {

/// The options of `touchstone cell run`, `serve` and `export` about the cell and its runs.
struct RunOptions {
  std::string file, meshes;
  std::vector<std::string> changes;
  std::vector<std::string> methods{"filtered",      "fast",     "fast-float",    "thesis",        "thesis-float",
                                   "thesis-0.9999", "thesis-1", "thesis-signed", "thesis-newell", "thesis-closed"};
  double overhang = 8;
};

/// Adds all options except the file. `options` must outlive the command.
void add_run_options(harness::Command& command, RunOptions& options);

/// Reads the cell and builds its model. Throws what read_cell, find_methods and build_model throw.
[[nodiscard]] browser::Simulator simulator_of(const RunOptions& options);

}  // namespace touchstone::cell

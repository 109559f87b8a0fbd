// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/methods/registry.h"
#include "experiments/program/command.h"
#include "experiments/thesis/cell/browser/recording.h"
#include "experiments/thesis/cell/model/plant.h"

namespace touchstone::cell {

/// The options of `touchstone cell run`, `serve` and `export` about the cell and its runs.
struct RunOptions {
  std::string file, meshes, preset, drive, piece;
  std::vector<std::string> changes;
  bool sphere_alone = false, thesis_order = false;
  methods::Selection methods{{"filtered", "fast", "fast-float", "thesis", "thesis-float", "thesis-0.9999", "thesis-1",
                              "thesis-signed", "thesis-newell", "thesis-closed"}};
};

/// Adds the options about the cell and the rule, except the file. `options` must outlive the command.
void add_cell_options(program::Command& command, RunOptions& options);
/// Adds these and the methods.
void add_run_options(program::Command& command, RunOptions& options);

/// Reads the file with the preset, then the changes applied. Throws what read_plant and preset throw.
[[nodiscard]] Plant plant_of(const RunOptions& options);
/// Returns the cell of the chosen piece, by default of the first one. Throws BadCell for an unknown name.
[[nodiscard]] Cell cell_of(const RunOptions& options);
/// Throws what find_methods throws.
[[nodiscard]] Rule rule_of(const RunOptions& options);

/// Reads the cell, with the options' changes before these, and builds its model. Throws what cell_of, rule_of,
/// find_methods and build_model throw.
[[nodiscard]] browser::Simulator simulator_of(RunOptions options, const browser::Variation& variation = {});

}  // namespace touchstone::cell

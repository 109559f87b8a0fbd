// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/run_options.h"

#include <memory>
#include <optional>
#include <utility>

#include "experiments/methods/registry.h"
#include "experiments/thesis/cell/model/read_cell.h"

namespace touchstone::cell {

void add_cell_options(program::Command& command, RunOptions& options) {
  command
      .texts("--set", options.changes,
             "Change the cell first: storage.angle=-33, machine.parts[3]=null; may be repeated")
      .takes("CHANGE");
  command.text("--preset", options.preset, "Apply a preset of the cell file first, such as `case 2`").takes("NAME");
  command.text("--piece", options.piece, "The piece of material that is handled, if the cell has several")
      .takes("NAME");
  command.flag("--sphere-alone", options.sphere_alone,
               "The thesis's rule: test the virtual sphere alone, not the arm, the gripper and what it holds");
  command.flag("--thesis-order", options.thesis_order,
               "Keep to the thesis's order of moves, of one joint each: find no other way");
  command.text("--drive", options.drive, "The method whose answer stops the robot, instead of the exact one")
      .takes("METHOD");
  command.text("--meshes", options.meshes, "The folder of mesh files, instead of the cell file's").takes("FOLDER");
}

void add_run_options(program::Command& command, RunOptions& options) {
  add_cell_options(command, options);
  methods::declare_methods(command, options.methods, "Methods to ask at every stop; `all` for every method");
}

Plant plant_of(const RunOptions& options) {
  std::vector<std::string> changes =
      options.preset.empty() ? std::vector<std::string>() : preset(options.file, options.preset);
  changes.insert(changes.end(), options.changes.begin(), options.changes.end());
  return read_plant(options.file, options.meshes.empty() ? std::nullopt : std::optional(options.meshes), changes);
}

namespace {

std::size_t chosen(const Plant& plant, const RunOptions& options) {
  return options.piece.empty() ? 0 : piece_named(plant, options.piece);
}

}  // namespace

Cell cell_of(const RunOptions& options) {
  const Plant plant = plant_of(options);
  return cell_of(plant, chosen(plant, options));
}

Rule rule_of(const RunOptions& options) {
  Rule rule{.sphere_alone = options.sphere_alone, .finds_ways = !options.thesis_order};
  if (!options.drive.empty() && options.drive != "exact") rule.drive = methods::find_methods({options.drive}).front();
  return rule;
}

browser::Simulator simulator_of(RunOptions options, const browser::Variation& variation) {
  options.changes.insert(options.changes.end(), variation.changes.begin(), variation.changes.end());
  if (!variation.piece.empty()) options.piece = variation.piece;
  auto methods = options.methods.methods();
  auto plant = std::make_shared<const Plant>(plant_of(options));
  const std::size_t piece = chosen(*plant, options);
  Cell cell = cell_of(*plant, piece);
  return {std::move(cell),
          {.methods = std::move(methods), .rule = rule_of(options), .plant = std::move(plant), .piece = piece}};
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/run_options.h"

#include <optional>

#include "experiments/cell/model/read_cell.h"
#include "experiments/methods/registry.h"

namespace touchstone::cell {

void add_run_options(harness::Command& command, RunOptions& options) {
  command.texts("--set", options.changes,
                "Change the cell first: storage.angle=-33, machine.parts[3]=null; may be repeated");
  command.text("--meshes", options.meshes, "The folder of mesh files, instead of the cell file's");
  command.methods(options.methods, "Methods to ask at every stop; `all` for every method");
  command.positive("--cover-margin", options.overhang, "By how much the balls that cover the arm may reach beyond it");
}

browser::Simulator simulator_of(const RunOptions& options) {
  auto methods = methods::find_methods(options.methods);
  return {
      read_cell(options.file, options.meshes.empty() ? std::nullopt : std::optional(options.meshes), options.changes),
      {.overhang = options.overhang, .methods = std::move(methods)}};
}

}  // namespace touchstone::cell

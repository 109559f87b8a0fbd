// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <string>

#include "experiments/thesis/cell/cell_commands.h"
#include "experiments/thesis/cell/gripper.h"

namespace touchstone::cell {

run::Command cases_command() {
  run::Command command("cases", "Print the gripper's cases of a run, as the corpus holds them");
  auto file = std::make_shared<std::string>();
  command.text("CELL", *file, "A cell file").required();
  command.example("cell cases experiments/thesis/cell/cells/aristo.json");
  command.runs([file] {
    fmt::print("{}", gripper_cases(*file));
    return 0;
  });
  return command;
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "experiments/cell/cell_commands.h"
#include "experiments/cell/gripper.h"

namespace touchstone::cell {

void add_cases(CLI::App& cell) {
  auto* command = cell.add_subcommand("cases", "Print the gripper's cases of a run, as the corpus holds them");
  auto file = std::make_shared<std::string>();
  command->add_option("CELL", *file, "A cell file")->required();
  command->callback([file] { fmt::print("{}", gripper_cases(*file)); });
}

}  // namespace touchstone::cell

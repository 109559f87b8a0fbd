// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>

#include "experiments/cell/cell_commands.h"

namespace touchstone::commands {

void add_cell(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("cell", "The virtual manufacturing cell: its model, its layout, its contacts");
  command->require_subcommand(1);
  cell::add_show(*command, status);
  cell::add_convert(*command, status);
  cell::add_layout(*command, status);
  cell::add_missed(*command, status);
  cell::add_run(*command, status);
  cell::add_area(*command, status);
  cell::add_serve(*command, status);
  cell::add_export(*command, status);
  cell::add_cases(*command);
}

}  // namespace touchstone::commands

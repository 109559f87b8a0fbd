// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/cell_commands.h"

namespace touchstone::commands {

run::Command cell_command() {
  return {
      "cell",
      "The virtual manufacturing cell: its model, its layout, its contacts",
      {cell::new_command(), cell::show_command(), cell::layout_command(), cell::missed_command(), cell::run_command(),
       cell::area_command(), cell::serve_command(), cell::export_command(), cell::cases_command()}};
}

}  // namespace touchstone::commands

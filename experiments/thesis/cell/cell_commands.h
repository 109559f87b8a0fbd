// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/program/command.h"

// The subcommands of `touchstone cell`. Each is defined beside what it runs.
namespace touchstone::cell {

[[nodiscard]] program::Command new_command();
[[nodiscard]] program::Command show_command();
[[nodiscard]] program::Command layout_command();
[[nodiscard]] program::Command missed_command();
[[nodiscard]] program::Command run_command();
[[nodiscard]] program::Command area_command();
[[nodiscard]] program::Command serve_command();
[[nodiscard]] program::Command export_command();
[[nodiscard]] program::Command cases_command();

}  // namespace touchstone::cell

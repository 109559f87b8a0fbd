// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/run/command.h"

// The subcommands of `touchstone cell`. Each is defined beside what it runs.
namespace touchstone::cell {

[[nodiscard]] run::Command new_command();
[[nodiscard]] run::Command show_command();
[[nodiscard]] run::Command layout_command();
[[nodiscard]] run::Command missed_command();
[[nodiscard]] run::Command run_command();
[[nodiscard]] run::Command area_command();
[[nodiscard]] run::Command serve_command();
[[nodiscard]] run::Command export_command();
[[nodiscard]] run::Command cases_command();

}  // namespace touchstone::cell

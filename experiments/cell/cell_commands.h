// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/harness/command.h"

// The subcommands of `touchstone cell`. Each is defined beside what it runs.
namespace touchstone::cell {

[[nodiscard]] harness::Command new_command();
[[nodiscard]] harness::Command show_command();
[[nodiscard]] harness::Command convert_command();
[[nodiscard]] harness::Command layout_command();
[[nodiscard]] harness::Command missed_command();
[[nodiscard]] harness::Command run_command();
[[nodiscard]] harness::Command area_command();
[[nodiscard]] harness::Command serve_command();
[[nodiscard]] harness::Command export_command();
[[nodiscard]] harness::Command cases_command();

}  // namespace touchstone::cell

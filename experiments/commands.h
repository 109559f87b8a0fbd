// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/program/command.h"
#include "experiments/studies.h"

// The subcommands of `touchstone`, with those of studies.h. Each is defined beside what it runs.
namespace touchstone::commands {

[[nodiscard]] program::Command ask_command();
[[nodiscard]] program::Command judge_command();
[[nodiscard]] program::Command methods_command();
[[nodiscard]] program::Command cases_command();
[[nodiscard]] program::Command cell_command();
[[nodiscard]] program::Command regress_command();
[[nodiscard]] program::Command corpus_command();
[[nodiscard]] program::Command thesis_command();
[[nodiscard]] program::Command show_command();

/// Returns the command that describes the tables of the other commands.
[[nodiscard]] program::Command columns_command(const std::vector<program::Command>& commands);
/// Returns the command that merges parts of any of these commands.
[[nodiscard]] program::Command merge_command(const std::vector<program::Command>& commands);

}  // namespace touchstone::commands

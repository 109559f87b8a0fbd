// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/run/command.h"
#include "experiments/studies.h"

// The subcommands of `touchstone`, with those of studies.h. Each is defined beside what it runs.
namespace touchstone::commands {

[[nodiscard]] run::Command ask_command();
[[nodiscard]] run::Command judge_command();
[[nodiscard]] run::Command methods_command();
[[nodiscard]] run::Command cases_command();
[[nodiscard]] run::Command cell_command();
[[nodiscard]] run::Command regress_command();
[[nodiscard]] run::Command corpus_command();
[[nodiscard]] run::Command thesis_command();
[[nodiscard]] run::Command show_command();

/// Returns the command that describes the tables of the other commands.
[[nodiscard]] run::Command columns_command(const std::vector<run::Command>& commands);
/// Returns the command that merges parts of any of these commands.
[[nodiscard]] run::Command merge_command(const std::vector<run::Command>& commands);

}  // namespace touchstone::commands

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/run/command.h"

namespace touchstone::commands {

/// Returns the command that prints a completion script for a shell and the one that writes the manual pages. Both cover
/// these commands and themselves. `about`: the text of the program; `heading`: under which it lists the two.
[[nodiscard]] std::vector<run::Command> help_commands(const std::string& about, const std::string& heading,
                                                      std::vector<run::Command> commands);

}  // namespace touchstone::commands

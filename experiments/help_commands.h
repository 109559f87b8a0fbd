// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "experiments/harness/command.h"

namespace touchstone::commands {

/// Returns the command that prints a completion script for a shell.
[[nodiscard]] harness::Command completion_command(const std::string& about,
                                                  const std::vector<harness::Command>& commands);
/// Returns the command that writes the manual pages.
[[nodiscard]] harness::Command manual_command(const std::string& about, const std::vector<harness::Command>& commands);

}  // namespace touchstone::commands

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "experiments/harness/command.h"

namespace touchstone::commands {

/// Returns the command that describes the tables of the other commands.
[[nodiscard]] harness::Command columns_command(const std::vector<harness::Command>& commands);

}  // namespace touchstone::commands

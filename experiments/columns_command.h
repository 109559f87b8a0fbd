// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "experiments/run/command.h"

namespace touchstone::commands {

/// Returns the command that describes the tables of the other commands.
[[nodiscard]] run::Command columns_command(const std::vector<run::Command>& commands);

}  // namespace touchstone::commands

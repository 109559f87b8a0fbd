// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "experiments/run/command_description.h"

namespace touchstone::run {

/// Returns a script that completes commands, options and their listed values in bash (4 or later). Other words are
/// completed as names of files.
[[nodiscard]] std::string bash_completion(const CommandDescription& program);

/// Returns the same for zsh, with the meanings of commands and options: the file `_touchstone` of a folder of $fpath.
[[nodiscard]] std::string zsh_completion(const CommandDescription& program);

}  // namespace touchstone::run

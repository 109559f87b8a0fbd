// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "experiments/run/command_description.h"

namespace touchstone::run {

/// Returns the help of a command, or of the program for an empty name.
///
/// No line is longer than `width`, except for a word that is itself longer; no word is cut. The second and later lines
/// of a meaning are indented as the first one. An example stays one command of a shell.
[[nodiscard]] std::string help_text(const CommandDescription& command, std::size_t width);

/// Returns the number of columns for help: the environment variable COLUMNS or, without it, the width of the terminal
/// to which standard output goes; otherwise 80.
[[nodiscard]] std::size_t help_width();

}  // namespace touchstone::run

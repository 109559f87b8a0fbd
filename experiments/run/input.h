// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace touchstone::run {

/// Opens a file to read its bytes. Throws std::runtime_error, which names the file and the reason, if it cannot be
/// opened or is a folder: `part.obj: cannot be read: No such file or directory`.
[[nodiscard]] std::ifstream open_file(const std::filesystem::path& file);

/// If standard input is a terminal, says on standard error that the command reads from it, what, and how to end that.
void announce_standard_input(const std::string& what);

}  // namespace touchstone::run

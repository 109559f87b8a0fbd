// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace touchstone::program {

/// Returns a file or folder of the program's data: the certified cases, the cells, and the scripts that draw pictures.
/// `name`: its path from the root of the source tree.
///
/// The data lie in the folder $TOUCHSTONE_DATA. Without this variable they lie in share/touchstone, in the folder of
/// the program (a build, where this is a link to the source tree) or beside it (an installation).
///
/// Throws std::runtime_error, which names the file or folder, if it is not there.
[[nodiscard]] std::filesystem::path data(const std::string& name);

/// Returns a program that only this one starts, in libexec/touchstone, in the folder of this program or beside it.
[[nodiscard]] std::filesystem::path helper_program(const std::string& name);

/// Opens a file to read its bytes. Throws std::runtime_error, which names the file and the reason, if it cannot be
/// opened or is a folder: `part.obj: cannot be read: No such file or directory`.
[[nodiscard]] std::ifstream open_file(const std::filesystem::path& file);

/// If standard input is a terminal, says on standard error that the command reads from it, what, and how to end that.
void announce_standard_input(const std::string& what);

}  // namespace touchstone::program

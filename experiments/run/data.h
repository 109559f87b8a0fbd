// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::run {

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

}  // namespace touchstone::run

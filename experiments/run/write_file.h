// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::run {

/// Writes the text, byte for byte. Throws std::runtime_error, which names the file, where it cannot be written.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace touchstone::run

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::run {

/// Writes the text, byte for byte. Throws std::runtime_error, which names the file, where it cannot be written.
void write_file(const std::filesystem::path& path, const std::string& text);

/// Throws std::runtime_error, which names the file, if something stands at `path` and `force` is not given. To be
/// called before time is spent; write_file then writes over it.
void refuse_overwriting(const std::filesystem::path& path, bool force);

/// As a field of a CSV file: quoted where that is needed.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Makes a folder, and those above it, if it is not there: what cannot be written to is refused before time is spent.
/// Throws std::runtime_error, which names the folder.
void make_folder(const std::filesystem::path& folder);

}  // namespace touchstone::run

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace touchstone::harness {

/// Writes the text, byte for byte: to a new file beside, which then takes the name. Readers thus find the earlier file
/// or the whole new one, and a symbolic link of that name is replaced, not followed.
///
/// Throws std::runtime_error, which names the file and says why, where it cannot be written; an earlier file then stays
/// as it was.
void write_file(const std::filesystem::path& path, const std::string& text);

/// The same for a command that writes one file. Without `force` throws what refuse_overwrite does, if something of that
/// name is there by now: of two commands that write one file, one succeeds.
void write_file(const std::filesystem::path& path, const std::string& text, bool force);

/// For a command that writes one file, before it spends time on what is to be written.
///
/// Throws std::runtime_error, which names the file, if something of that name is there already: anything without
/// `force`; with it, what is no regular file (a folder, a device, a symbolic link).
void refuse_overwrite(const std::filesystem::path& file, bool force);

/// As a field of a CSV file: quoted where that is needed.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Makes a folder, and those above it, if it is not there: what cannot be written to is refused before time is spent.
/// Throws std::runtime_error, which names the folder.
void make_folder(const std::filesystem::path& folder);

}  // namespace touchstone::harness

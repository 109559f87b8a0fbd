// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace touchstone::run {

/// Writes the text, byte for byte, to a new file beside the target, which then takes its name. Readers thus find the
/// earlier file or the complete new one, also after the machine has failed: the text is on the disk before the file
/// takes its name, and the name before this returns. A symbolic link of that name is replaced, not followed.
///
/// Throws std::runtime_error, which names the file and the reason, if it cannot be written; an earlier file is then
/// unchanged.
void write_file(const std::filesystem::path& path, const std::string& text);

/// The same for a command that writes one file. Without `force`, throws like refuse_overwrite if the file exists by
/// now: if two commands write the same file, one succeeds. Removes what killed processes left of earlier attempts.
void write_file(const std::filesystem::path& path, const std::string& text, bool force);

/// Returns whether this is the name of a file that write_file (or experiments/report/replacing.py) writes, before the
/// file takes its own: NAME.new- and the number of the process. A killed process leaves such a file.
[[nodiscard]] bool is_unfinished(std::string_view name);

/// Checks the target of a command that writes one file, before the command computes its content.
///
/// Throws std::runtime_error, which names the file: without `force`, if anything of that name exists; with `force`, if
/// that is not a regular file (a folder, a device, a symbolic link).
void refuse_overwrite(const std::filesystem::path& file, bool force);

/// Returns the text as a field of a CSV file, quoted if needed.
[[nodiscard]] std::string csv_field(const std::string& text);

/// Creates a folder and its parents if it does not exist, so that a folder that cannot be written to is reported before
/// the work begins. Returns whether it did not exist. Throws std::runtime_error, which names the folder.
bool make_folder(const std::filesystem::path& folder);

}  // namespace touchstone::run

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::harness {

/// What a sidecar says of a run besides the compiler, the flags, the commit, the machine and the date.
struct Run {
  std::string command;
  std::uint64_t seed = 0;
  std::uint64_t samples_asked = 0, samples_done = 0, samples_missing = 0;
  unsigned threads = 1;  ///< of each process
  double seconds = 0;
  unsigned processes = 1;
  std::optional<bool> interrupted{};  ///< where a study says so
};

/// Writes run.json. Throws std::runtime_error where it cannot be written.
void write_run_record(const std::filesystem::path& folder, const Run& run);

/// The folder of the sources: $TOUCHSTONE_SOURCE_DIR, else where the program was built from.
[[nodiscard]] std::filesystem::path source_folder();
/// As in `2026-11-23T03:19:51Z`.
[[nodiscard]] std::string utc_now();
/// As one word of a shell command.
[[nodiscard]] std::string shell_quoted(const std::string& word);
/// As the value of an option: words separated by commas.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace touchstone::harness

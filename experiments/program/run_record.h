// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::program {

/// The facts that run.json records about a run besides the compiler, the flags, the commit, the machine and the date.
struct Run {
  std::string command{};
  std::uint64_t seed = 0;
  std::uint64_t samples_asked = 0, samples_done = 0, samples_missing = 0;
  unsigned threads = 1;
  double seconds = 0;                 ///< of a merge, its own
  std::string part{};                 ///< I/N, if the run was a part of a study
  std::uint64_t parts = 1;            ///< that were merged; 1: none
  std::optional<bool> interrupted{};  ///< only for studies that report it
};

/// Writes run.json. Throws std::runtime_error if it cannot be written.
void write_run_record(const std::filesystem::path& folder, const Run& run);

/// Returns the version of the project, the commit, the compiler and the optional engines of this build: a line each.
[[nodiscard]] std::string version_text();
/// Returns the current time as `2026-11-23T03:19:51Z`.
[[nodiscard]] std::string utc_now();
/// Joins words with commas, as the value of an option.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

}  // namespace touchstone::program

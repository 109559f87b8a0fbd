// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/judge/regress/outcome_table.h"

namespace touchstone::regress {

/// The outcomes of all cases that later runs are compared with, as a JSON file. For each method and group, hexadecimal
/// digits mark the wrong cases: four cases per digit, the first case in the highest bit. The unsure cases are marked
/// likewise, for methods that are unsure about any case. Equal outcomes give equal bytes.
struct Baseline {
  Settings settings;
  OutcomeTable table;
};

/// An upper bound of the length of baseline_text for any settings and all methods.
inline constexpr std::size_t kLongestBaseline = std::size_t{1} << 30;

[[nodiscard]] std::string baseline_text(const Baseline& baseline);
/// Reads a baseline. Throws std::runtime_error, which names the file and its fault: it is longer than `longest` bytes,
/// is not JSON, lacks a key or has an unknown one.
[[nodiscard]] Baseline read_baseline(const std::filesystem::path& file, std::size_t longest = kLongestBaseline);

/// For one method and group, the numbers of the cases whose outcome is better or worse than in the baseline.
struct Change {
  std::string method;
  Group group;
  std::vector<std::size_t> better, worse;
};

/// Returns the changes of the methods that both have, groups in their order. Requires equal settings.
[[nodiscard]] std::vector<Change> changes(const OutcomeTable& baseline, const OutcomeTable& now);

}  // namespace touchstone::regress

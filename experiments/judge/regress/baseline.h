// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/judge/regress/outcome_table.h"

namespace touchstone::regress {

/// A standing that others are held against, as a file: JSON, the cases of a family that a method is wrong about as
/// hexadecimal digits, four cases a digit, the first case in the highest bit; so, too, those that it is unsure about,
/// if it is about any of all families. Equal standings make equal bytes.
struct Baseline {
  Settings settings;
  OutcomeTable table;
};

/// Longer than baseline_text of any settings and all methods.
inline constexpr std::size_t kLongestBaseline = std::size_t{1} << 30;

[[nodiscard]] std::string baseline_text(const Baseline& baseline);
/// Throws std::runtime_error, which names the file and what is wrong with it: it is longer than so many bytes,
/// is not JSON, lacks a key or has one that is not known.
[[nodiscard]] Baseline read_baseline(const std::filesystem::path& file, std::size_t longest = kLongestBaseline);

/// Of one method and family, the numbers of the cases whose outcome is better or worse than in the baseline.
struct Change {
  std::string method, family;
  std::vector<std::size_t> better, worse;
};

/// The changes of those methods that both have; families in their order. Requires equal settings.
[[nodiscard]] std::vector<Change> changes(const OutcomeTable& baseline, const OutcomeTable& now);

}  // namespace touchstone::regress

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/regress/standing.h"

namespace touchstone::regress {

/// A standing that others are held against, as a file: JSON, the failures of a family as hexadecimal digits, four cases
/// a digit, the first case in the highest bit. Equal standings make equal bytes.
struct Baseline {
  Settings settings;
  Standing standing;
};

[[nodiscard]] std::string baseline_text(const Baseline& baseline);
/// Throws std::runtime_error, which names the file and what is wrong with it.
[[nodiscard]] Baseline read_baseline(const std::filesystem::path& file);

/// What is otherwise than in the baseline: of one method and family, the numbers of cases.
struct Change {
  std::string method, family;
  std::vector<std::size_t> better, worse;
};

/// The changes of those methods that both have; families in their order. Requires equal settings.
[[nodiscard]] std::vector<Change> changes(const Standing& baseline, const Standing& now);

}  // namespace touchstone::regress

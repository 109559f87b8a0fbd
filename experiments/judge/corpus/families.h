// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::corpus {

/// Raised whenever a case is added, changes or leaves.
inline constexpr int kVersion = 3;
/// No file is larger: it is to be read.
inline constexpr std::size_t kMostBytes = 300'000;

/// One file of the corpus.
struct Family {
  std::string_view name;     ///< the file's, without `.jsonl`
  std::string_view subject;  ///< what it tests
  std::string (*text)();     ///< its lines
};

/// In the order of the page that tells of them.
///
/// A text is the same whenever and wherever it is made: cases are drawn as functions of (seed, index), or read from
/// experiments/judge/corpus/given. It holds the exact answers. Texts throw std::runtime_error, which names the file and
/// line, where a given case cannot be used, and std::logic_error where one is larger than kMostBytes. (Some cases of
/// `soak` are drawn in long doubles: those of x86-64.)
[[nodiscard]] const std::vector<Family>& all_families();

}  // namespace touchstone::corpus

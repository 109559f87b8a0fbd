// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::corpus {

/// The version of the corpus, raised whenever a case is added, changes or is removed.
inline constexpr int kVersion = 6;
/// The maximal size of a file, because people read it.
inline constexpr std::size_t kMostBytes = 350'000;

/// The numbers of the cases: any doubles, or floats alone (in_floats.h).
enum class Numbers { Doubles, Floats };

/// One file of the corpus, or two: one of doubles and one of floats.
struct Family {
  std::string_view name;         ///< of the file, without `.jsonl`
  std::string_view subject;      ///< what it tests
  std::string (*text)(Numbers);  ///< its lines; empty if the family has no cases in these numbers
};

/// Returns the families in the order of the page that describes them.
///
/// A text is always the same: cases are drawn as functions of (seed, index), or read from
/// experiments/judge/corpus/given. It holds the exact answers. Texts throw std::runtime_error, which names the file and
/// line, if a given case cannot be used, and std::logic_error if a text is larger than kMostBytes. (Some cases of
/// `soak` are drawn in long doubles: those of x86-64.)
[[nodiscard]] const std::vector<Family>& all_families();

}  // namespace touchstone::corpus

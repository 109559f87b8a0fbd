// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/similar_words.h"

#include <algorithm>

namespace touchstone::program {

std::size_t misspellings(std::string_view word, std::string_view meant) {
  std::vector<std::size_t> before_last, last, row(meant.size() + 1);
  for (std::size_t j = 0; j <= meant.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= word.size(); ++i) {
    before_last = std::move(last);
    last = std::move(row);
    row.assign(meant.size() + 1, i);
    for (std::size_t j = 1; j <= meant.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (word[i - 1] == meant[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && word[i - 1] == meant[j - 2] && word[i - 2] == meant[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string> most_similar(std::string_view word, const std::vector<std::string>& known) {
  const auto begins = [&](const std::string& one) { return one.starts_with(word); };
  if (std::ranges::count_if(known, begins) == 1) return *std::ranges::find_if(known, begins);
  std::optional<std::string> best;
  std::size_t fewest = word.size() / 3 + 1;  // one more than is taken
  for (const std::string& one : known)
    if (const std::size_t count = misspellings(word, one); count < fewest) {
      fewest = count;
      best = one;
    }
  return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const auto meant = most_similar(word, known);
  return meant ? "; did you mean " + *meant + "?" : "";
}

}  // namespace touchstone::program

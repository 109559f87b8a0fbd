// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::program {

/// Returns the number of letters that are inserted, left out, replaced or swapped with their neighbour to turn one word
/// into the other (optimal string alignment). Cost: the product of the lengths.
[[nodiscard]] std::size_t misspellings(std::string_view word, std::string_view meant);

/// Returns the known word that was probably meant: the only one that begins with `word`, or else the one with the
/// fewest misspellings, if these are at most a third of the letters; the first of equals.
[[nodiscard]] std::optional<std::string> most_similar(std::string_view word, const std::vector<std::string>& known);

/// Returns `; did you mean X?` for the most similar word, or an empty text.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace touchstone::program

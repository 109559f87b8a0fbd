// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The words of command lines: how a shell quotes them, which numbers they are, and which words were probably meant.
namespace touchstone::program {

/// Quotes a text as one word of a shell command.
[[nodiscard]] std::string shell_quoted(const std::string& word);
/// Returns the words of a line of plain and quoted words, with what a shell would take of quotes and backslashes.
[[nodiscard]] std::vector<std::string> shell_words(const std::string& line);

/// Reads a whole number without a sign, of digits or, like `1e6`, of digits and a power of ten. Returns nothing if the
/// text is anything else, or if the number exceeds 2^64 - 1.
[[nodiscard]] std::optional<std::uint64_t> read_whole_number(std::string_view text);

/// Returns a check for options of the command line. The check returns an empty string if read_whole_number reads a
/// number from `lowest` to `highest`; otherwise it returns the fault.
[[nodiscard]] std::function<std::string(const std::string&)> whole_number(
    std::uint64_t lowest, std::uint64_t highest = std::numeric_limits<std::uint64_t>::max());

/// Returns a check for options of the command line. The check returns an empty string if the text is a decimal number
/// whose nearest double is from `lowest` to `highest`, and which does not round to 0 without being 0; otherwise it
/// returns the fault.
[[nodiscard]] std::function<std::string(const std::string&)> real_number(double lowest, double highest);

/// Returns the number of letters that are inserted, left out, replaced or swapped with their neighbour to turn one word
/// into the other (optimal string alignment). Cost: the product of the lengths.
[[nodiscard]] std::size_t misspellings(std::string_view word, std::string_view meant);

/// Returns the known word that was probably meant: the only one that begins with `word`, or else the one with the
/// fewest misspellings, if these are at most a third of the letters; the first of equals.
[[nodiscard]] std::optional<std::string> most_similar(std::string_view word, const std::vector<std::string>& known);

/// Returns `; did you mean X?` for the most similar word, or an empty text.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace touchstone::program

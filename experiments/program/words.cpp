// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/words.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "geometry/io/detail/text_number.h"

namespace touchstone::program {

std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  bool quoted = false, within = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!quoted && line[i] == ' ') {
      within = false;
      continue;
    }
    if (!std::exchange(within, true)) words.emplace_back();
    if (line[i] == '\'')
      quoted = !quoted;
    else if (!quoted && line[i] == '\\' && i + 1 < line.size())
      words.back() += line[++i];
    else
      words.back() += line[i];
  }
  return words;
}

std::optional<std::uint64_t> read_whole_number(std::string_view text) {
  const auto digits = [](std::string_view part) -> std::optional<std::uint64_t> {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    return error == std::errc() && end == part.data() + part.size() ? std::optional(number) : std::nullopt;
  };
  const std::size_t e = text.find_first_of("eE");
  auto number = digits(text.substr(0, e));
  const auto exponent = e == std::string_view::npos ? 0 : digits(text.substr(e + 1));
  if (!number || !exponent) return std::nullopt;
  for (std::uint64_t i = 0; i<*exponent&& * number> 0; ++i) {
    if (*number > std::numeric_limits<std::uint64_t>::max() / 10) return std::nullopt;
    *number *= 10;
  }
  return number;
}

std::function<std::string(const std::string&)> whole_number(std::uint64_t lowest, std::uint64_t highest) {
  return [lowest, highest](const std::string& text) -> std::string {
    if (const auto number = read_whole_number(text); number && *number >= lowest && *number <= highest) return {};
    const std::string last =
        highest == std::numeric_limits<std::uint64_t>::max() ? "2^64 - 1" : std::to_string(highest);
    return fmt::format("\"{}\" is not a whole number from {} to {}", text, lowest, last);
  };
}

std::function<std::string(const std::string&)> real_number(double lowest, double highest) {
  return [lowest, highest](const std::string& text) -> std::string {
    const auto value = io::nearest_double(text);
    if (!value || !(*value >= lowest && *value <= highest))
      return fmt::format("\"{}\" is not a number from {} to {}", text, lowest, highest);
    const std::string_view digits = std::string_view(text).substr(0, text.find_first_of("eE"));
    if (*value == 0 && digits.find_first_of("123456789") != std::string_view::npos)
      return fmt::format("\"{}\" is not 0, but nearer to 0 than to any other double", text);
    return {};
  };
}

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

// SPDX-License-Identifier: GPL-3.0-or-later
// Own code, since one declaration of columns gives the CSV file, the text for the terminal and the page that explains
// them. A library for terminal tables would replace only `aligned`.
#include "experiments/program/table.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "experiments/program/statistics/shares.h"

namespace touchstone::program {

std::string text_field(std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string number_field(std::int64_t number, const char* format) { return fmt::format(fmt::runtime(format), number); }

std::string number_field(std::uint64_t number, const char* format) { return fmt::format(fmt::runtime(format), number); }

std::string number_field(double number, const char* format) { return fmt::format(fmt::runtime(format), number); }

namespace {

bool is_number(const std::string& field) {
  double number = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  return error == std::errc() && end == field.data() + field.size();
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  const std::size_t columns = lines.front().size();
  std::vector<std::size_t> widths(columns);
  std::vector<bool> to_the_right(columns, true);
  for (const auto& line : lines)
    for (std::size_t c = 0; c < columns; ++c) {
      widths[c] = std::max(widths[c], line[c].size());
      if (&line != &lines.front() && !line[c].empty() && !is_number(line[c])) to_the_right[c] = false;
    }
  std::string text;
  for (const auto& line : lines) {
    std::string printed;
    for (std::size_t c = 0; c < columns; ++c)
      printed += fmt::format(fmt::runtime(to_the_right[c] ? "{:>{}}  " : "{:<{}}  "), line[c], widths[c]);
    printed.resize(printed.find_last_not_of(' ') + 1);
    text += printed + "\n";
  }
  return text;
}

Rate rate(std::uint64_t count, std::uint64_t trials) {
  const auto limits = statistics::clopper_pearson(count, trials);
  return {trials == 0 ? 0 : static_cast<double>(count) / static_cast<double>(trials), limits.lower, limits.upper};
}

}  // namespace touchstone::program

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/numbers.h"

#include <fmt/core.h>

#include <charconv>
#include <string_view>
#include <system_error>

#include "geometry/io/detail/text_number.h"

namespace touchstone::program {

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

}  // namespace touchstone::program

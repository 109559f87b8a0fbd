// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/whole_number.h"

#include <fmt/core.h>

#include <charconv>
#include <system_error>

namespace touchstone::harness {

std::function<std::string(const std::string&)> whole_number(std::uint64_t lowest, std::uint64_t highest) {
  return [lowest, highest](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size() && number >= lowest && number <= highest) return {};
    const std::string last =
        highest == std::numeric_limits<std::uint64_t>::max() ? "2^64 - 1" : std::to_string(highest);
    return fmt::format("\"{}\" is not a whole number from {} to {}", text, lowest, last);
  };
}

}  // namespace touchstone::harness

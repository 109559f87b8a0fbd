// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone::program {

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

/// Returns the number with its noun: `1 ball`, `2 balls`.
[[nodiscard]] inline std::string counted(std::uint64_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

}  // namespace touchstone::program

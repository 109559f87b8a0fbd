// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace touchstone::harness {

/// A check for options of the command line: the empty string where the text is a whole number without a sign from
/// `lowest` to `highest`, else what is wrong. Without it -1 would be taken as 2^64 - 1.
[[nodiscard]] std::function<std::string(const std::string&)> whole_number(
    std::uint64_t lowest, std::uint64_t highest = std::numeric_limits<std::uint64_t>::max());

}  // namespace touchstone::harness

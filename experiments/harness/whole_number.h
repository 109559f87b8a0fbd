// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace touchstone::harness {

/// Returns a check for options of the command line. The check returns an empty string if the text is a whole number
/// without a sign from `lowest` to `highest`; otherwise it returns the fault. Without the check, -1 would be read as
/// 2^64 - 1.
[[nodiscard]] std::function<std::string(const std::string&)> whole_number(
    std::uint64_t lowest, std::uint64_t highest = std::numeric_limits<std::uint64_t>::max());

}  // namespace touchstone::harness

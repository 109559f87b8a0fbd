// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

/// Shares in percent, for people. Nothing looks like 0 or 100 % that is not: `<0.01`, `>99.9`.
namespace touchstone::statistics {

/// Returns part / whole; 0 / 0 gives 0.
[[nodiscard]] double share_of(std::uint64_t part, std::uint64_t whole);

/// Formats a share as a percentage with `places` decimal places; exact shares of 0 and 1 have none.
[[nodiscard]] std::string percent_to_places(double share, int places);

/// Formats a share as a percentage with `digits` significant digits, and with at least one decimal place if it would
/// otherwise read as 100.
[[nodiscard]] std::string percent_to_digits(double share, int digits);

}  // namespace touchstone::statistics

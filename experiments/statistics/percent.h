// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

/// Shares in percent, for people. Nothing looks like 0 or 100 % that is not: `<0.01`, `>99.9`.
namespace touchstone::statistics {

/// part / whole; 0 of 0 is 0.
[[nodiscard]] double share_of(std::uint64_t part, std::uint64_t whole);

/// With so many decimal places; 0 and 100 without any.
[[nodiscard]] std::string percent_to_places(double share, int places);

/// To so many significant digits; one place at least where it would look like 100.
[[nodiscard]] std::string percent_to_digits(double share, int digits);

}  // namespace touchstone::statistics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace touchstone::stability {

/// The effect of contracting products and sums to fused multiply-adds on the sign of an expression in doubles: the same
/// expressions of signs.h, with and without std::fma, independently of the compiler's flags.
struct ContractionCount {
  std::string_view sign;    ///< orientation (of three points in the plane), side, line, plane
  std::string_view family;  ///< the exact sign is zero, or one double beside zero
  std::uint64_t trials = 0, plain_wrong = 0, fused_wrong = 0, differ = 0;
};

/// Runs `trials` of each sign and family; a function of (trials, seed). Orientation and side use vectors with all bits
/// set, one of them a power of two times the other; line and plane use balls that touch a lattice triangle exactly
/// (bench). For signs beside zero, one coordinate or the radius is moved by one double. Cost: about 30 us per trial of
/// all signs.
[[nodiscard]] std::vector<ContractionCount> count_contractions(std::uint64_t trials, std::uint64_t seed);

}  // namespace touchstone::stability

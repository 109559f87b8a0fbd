// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "robust/filtered/detail/numbers/target.h"

namespace touchstone::filtered::detail {

inline namespace TOUCHSTONE_TARGET {

/// Returns 2^exponent. Requires an exponent from -1022 to 1023.
__attribute__((always_inline)) inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace TOUCHSTONE_TARGET

/// A power of two as the unit of length. Converts by two factors each way, because the quotient of two lengths may be
/// no double.
struct LengthUnit {
  int exponent;    ///< the unit is 2^exponent, from 2^-2044 to 2^2044
  double down[2];  ///< two factors whose product is 2^-exponent
  double up[2];    ///< two factors whose product is 2^exponent

  // Always inlined, as DoubleWord's functions are.
  __attribute__((always_inline)) explicit LengthUnit(int e)
      : exponent(e),
        down{power_of_two(-(e / 2)), power_of_two(e / 2 - e)},
        up{power_of_two(e / 2), power_of_two(e - e / 2)} {}

  /// Returns the length in this unit, rounded where that loses bits.
  [[nodiscard]] __attribute__((always_inline)) double scaled(double length) const { return length * down[0] * down[1]; }
  /// Returns the length that is `scaled` in this unit. Exact if it is a normal double.
  [[nodiscard]] __attribute__((always_inline)) double unscaled(double scaled) const { return scaled * up[0] * up[1]; }
  /// Returns whether scaling the length loses no bit. Requires subnormal numbers.
  [[nodiscard]] __attribute__((always_inline)) bool is_exact(double length) const {
    return unscaled(scaled(length)) == length;  // exact
  }
};

}  // namespace touchstone::filtered::detail

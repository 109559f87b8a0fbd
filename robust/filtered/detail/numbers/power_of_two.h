// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "robust/filtered/detail/target.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Returns 2^exponent. Requires an exponent from -1022 to 1023.
__attribute__((always_inline)) inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

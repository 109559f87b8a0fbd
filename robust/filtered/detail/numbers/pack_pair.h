// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/lanes.h"

/// Packs of doubles as the words of double_double.h.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Four unevaluated sums high + low.
using PackPair = DoubleWord<Pack>;

TOUCHSTONE_INLINE Pack multiplied(double factor, const Pack& a) { return all_lanes(factor) * a; }
#if defined(__FMA__)
TOUCHSTONE_INLINE Pack fused_multiply_subtract(const Pack& a, const Pack& b, const Pack& c) {
  return multiply_subtract(a, b, c);
}
#endif

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/pack.h"

#if defined(__clang__)
#pragma clang fp reassociate(off)  // as in double_double.h
#endif

/// The error-free transformations of double_double.h, each for four doubles.
///
/// Requires what those require. Source: [dekker1971], [joldes2017].
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Four unevaluated sums high + low.
struct PackPair {
  Pack high, low;
};

/// a + b exactly.
TOUCHSTONE_INLINE PackPair two_sum(const Pack& a, const Pack& b) {
  const Pack sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly.
TOUCHSTONE_INLINE PackPair two_difference(const Pack& a, const Pack& b) {
  const Pack difference = a - b, b_part = difference - a;
  return {difference, (a - (difference - b_part)) - (b + b_part)};
}

/// a b exactly.
TOUCHSTONE_INLINE PackPair two_product(const Pack& a, const Pack& b) {
  const Pack product = a * b;
#if defined(__FMA__)
  return {product, multiply_subtract(a, b, product)};
#else
  const Pack splitter = all_lanes(0x1p27 + 1);
  const Pack a_shifted = splitter * a, a_high = a_shifted - (a_shifted - a), a_low = a - a_high;
  const Pack b_shifted = splitter * b, b_high = b_shifted - (b_shifted - b), b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/lanes.h"

/// Vectors of double-doubles whose components share a pack, and the sums of their products, for one sign. Products take
/// a third of the instructions of those of Vector3<DoubleDouble>. They are made by the same operations of
/// double_double.h, but nothing is normalised: the steps to a sign would be a third more. So constants of signs hold
/// kUnnormalised times.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// Packs of doubles as the words of double_double.h.

/// Four unevaluated sums high + low.
using PackPair = DoubleWord<Pack>;

TOUCHSTONE_INLINE Pack multiplied(double factor, const Pack& a) { return all_lanes(factor) * a; }
#if defined(TOUCHSTONE_FUSED)
TOUCHSTONE_INLINE Pack fused_multiply_subtract(const Pack& a, const Pack& b, const Pack& c) {
  return multiply_subtract(a, b, c);
}
#endif

/// A vector; lane 3 does not matter.
struct LaneVector {
  PackPair lanes;
};

/// Returns to - from, exact.
TOUCHSTONE_INLINE LaneVector difference(const double* to, const double* from) {
  return {two_difference(load_three(to), load_three(from))};
}

/// An unevaluated sum high + low, the low part of which may be many units in the last place of the high part.
struct Unnormalised {
  DoubleDouble sum;
};

TOUCHSTONE_INLINE Unnormalised dot(const LaneVector& a, const LaneVector& b) {
  const PackPair products = unnormalised_product(a.lanes, b.lanes);
  double high[kLanes], low[kLanes];
  store(high, products.high), store(low, products.low);
  return {
      unnormalised_sum(DoubleDouble(high[0], low[0]), DoubleDouble(high[1], low[1]), DoubleDouble(high[2], low[2]))};
}

TOUCHSTONE_INLINE PackPair next_of_three(const PackPair& a) { return {next_of_three(a.high), next_of_three(a.low)}; }

TOUCHSTONE_INLINE LaneVector cross(const LaneVector& a, const LaneVector& b) {
  // Component z in lane 0, x in lane 1, y in lane 2.
  const PackPair turned = unnormalised_difference(a.lanes, next_of_three(b.lanes), next_of_three(a.lanes), b.lanes);
  return {next_of_three(turned)};
}

TOUCHSTONE_INLINE Unnormalised operator*(const Unnormalised& a, const Unnormalised& b) {
  return {unnormalised_product(a.sum, b.sum)};
}
/// Returns a double that has the sign of a - b where a sign's bound is larger than its error (proved in
/// lone_sign_test.cpp).
TOUCHSTONE_INLINE double operator-(const Unnormalised& a, const Unnormalised& b) {
  return (a.sum.high - b.sum.high) + (a.sum.low - b.sum.low);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

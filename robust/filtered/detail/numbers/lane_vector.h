// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/lanes.h"

/// Vectors of double-doubles whose components share a pack. Their products take a third of the instructions of those of
/// Vector3<DoubleDouble>, and are made by the same operations of double_double.h: all its bounds hold.
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

TOUCHSTONE_INLINE DoubleDouble dot(const LaneVector& a, const LaneVector& b) {
  const PackPair products = unnormalised_product(a.lanes, b.lanes);
  double high[kLanes], low[kLanes];
  store(high, products.high), store(low, products.low);
  return sum_of_products(DoubleDouble(high[0], low[0]), DoubleDouble(high[1], low[1]), DoubleDouble(high[2], low[2]));
}

TOUCHSTONE_INLINE PackPair next_of_three(const PackPair& a) { return {next_of_three(a.high), next_of_three(a.low)}; }

TOUCHSTONE_INLINE LaneVector cross(const LaneVector& a, const LaneVector& b) {
  // Component z in lane 0, x in lane 1, y in lane 2.
  const PackPair turned = product_difference(a.lanes, next_of_three(b.lanes), next_of_three(a.lanes), b.lanes);
  return {next_of_three(turned)};
}

/// A radius, a multiple of whose square every sign subtracts last.
struct Radius {
  double value;
};
/// Such a multiple. Its low part is at most 4 u times the product of which it is the rest.
struct RadiusTerm {
  DoubleDouble value;
};
TOUCHSTONE_INLINE RadiusTerm operator*(const Radius& a, const Radius& b) { return {two_product(a.value, b.value)}; }
TOUCHSTONE_INLINE RadiusTerm operator*(const RadiusTerm& a, const DoubleDouble& b) {
  return {unnormalised_product(a.value, b)};
}
/// Returns a double that has the sign of a - b where the bound of the difference tells it: what this rounds costs less
/// than what that bound allows a difference of double-doubles (proved in lone_sign_test.cpp).
TOUCHSTONE_INLINE double operator-(const DoubleDouble& a, const RadiusTerm& b) {
  return (a.high - b.value.high) + (a.low - b.value.low);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

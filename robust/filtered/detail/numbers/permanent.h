// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/floating_point.h"
#include "robust/filtered/detail/numbers/target.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A double that carries its own error bound: the permanent, which is the value of the expression if every difference
/// is replaced by a sum of magnitudes.
///
/// Guarantee, with u = 2^-53 in round to nearest, exact value V and exact permanent M of the expression:
///   |value - V| <= ((1+u)^Roundings - 1) M + underflow, and |permanent - M| <= ((1+u)^Roundings - 1) M + underflow.
/// By induction over the operations: a rounded sum has the larger count of its terms plus one, a rounded product the
/// sum of the counts plus one. So the type itself does the error calculus; robust/proofs repeats it in rationals over
/// the recorded operations.
template <int Roundings>
struct Permanent {
  double value, permanent;
};

/// Returns a number that is exactly a double.
inline Permanent<0> exact_double(double value) { return {value, std::abs(value)}; }
/// Returns a number known to half a unit in the last place of its double.
inline Permanent<1> rounded_double(double value) { return {value, std::abs(value)}; }

template <int A, int B>
Permanent<std::max(A, B) + 1> operator+(const Permanent<A>& a, const Permanent<B>& b) {
  return {a.value + b.value, a.permanent + b.permanent};
}
template <int A, int B>
Permanent<std::max(A, B) + 1> operator-(const Permanent<A>& a, const Permanent<B>& b) {
  return {a.value - b.value, a.permanent + b.permanent};
}
template <int A, int B>
Permanent<A + B + 1> operator*(const Permanent<A>& a, const Permanent<B>& b) {
  return {a.value * b.value, a.permanent * b.permanent};
}

/// Returns the sign if the bound makes it certain, else 0. `tiny` covers the effect of underflow (bounds::kTiny).
template <int Roundings>
int certain_sign(const Permanent<Roundings>& number, double tiny) {
  // (1+u)^k - 1 <= (k + 1/16) u for k <= 2^20; the rest of the eighth covers the rounding of the permanent and of
  // this product.
  const double bound = (Roundings + 0.125) * 0x1p-53 * number.permanent + tiny;
  return (number.value > bound) - (number.value < -bound);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

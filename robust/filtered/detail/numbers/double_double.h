// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/floating_point.h"
#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/stage.h"  // before DoubleDouble: g++ 12 warns that Stage::DoubleDouble shadows it

#if defined(__clang__)
// clang++ defines no macro for the flags that reorder sums. Error-free sums must not be reordered, even so.
#pragma clang fp reassociate(off)
#endif

/// Error-free transformations and the arithmetic of unevaluated sums of two doubles.
///
/// Requires round to nearest and neither overflow nor underflow of any intermediate result; compiled without
/// contraction. Source: [dekker1971], [joldes2017].
namespace touchstone::filtered::detail {

/// The number high + low, with |low| <= ulp(high) / 2. Words are doubles; robust/proofs runs the templates below over
/// words that record the operations.
template <class Word>
struct DoubleWord {
  Word high, low;

  // Always inlined: a compiled function that was built for AVX2 could be linked into code for other machines.
  __attribute__((always_inline)) constexpr DoubleWord() : high(0), low(0) {}
  __attribute__((always_inline)) constexpr DoubleWord(Word value) : high(value), low(0) {}  // NOLINT: it is one
  __attribute__((always_inline)) constexpr DoubleWord(Word h, Word l) : high(h), low(l) {}
};

/// Relative error of an operation: + and - 3 u^2 + 13 u^3, * 7 u^2, with u = 2^-53; so each is below 2^-103
/// (bounds::kDoubleDoubleUnit).
using DoubleDouble = DoubleWord<double>;

inline namespace TOUCHSTONE_TARGET {

/// @{
/// What the functions below need of words. Packs of doubles (lane_vector.h) have the same.
__attribute__((always_inline)) inline double multiplied(double factor, double a) { return factor * a; }
#if defined(TOUCHSTONE_FUSED)
__attribute__((always_inline)) inline double fused_multiply_subtract(double a, double b, double c) {
  return __builtin_fma(a, b, -c);
}
#endif
/// @}

/// a + b exactly. Requires |a| >= |b| or a = 0.
template <class Word>
inline DoubleWord<Word> quick_two_sum(const Word& a, const Word& b) {
  const Word sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> two_sum(const Word& a, const Word& b) {
  const Word sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a - b exactly.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> two_difference(const Word& a, const Word& b) {
  const Word difference = a - b, b_part = difference - a;
  return {difference, (a - (difference - b_part)) - (b + b_part)};
}

/// a b exactly. Requires |a|, |b| < 2^995.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> two_product(const Word& a, const Word& b) {
  const Word product = a * b;
#if defined(TOUCHSTONE_FUSED)
  return {product, fused_multiply_subtract(a, b, product)};
#else
  constexpr double splitter = 0x1p27 + 1;
  const Word a_shifted = multiplied(splitter, a), a_high = a_shifted - (a_shifted - a), a_low = a - a_high;
  const Word b_shifted = multiplied(splitter, b), b_high = b_shifted - (b_shifted - b), b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

__attribute__((always_inline)) inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

__attribute__((always_inline)) inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(sum.high, low.low + sum.low);
}
__attribute__((always_inline)) inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

__attribute__((always_inline)) inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// Returns the high part of a b, and the rest to within 8 u^2 |a b|. Sums of products add the two parts separately.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> unnormalised_product(const DoubleWord<Word>& a,
                                                                            const DoubleWord<Word>& b) {
  const DoubleWord<Word> product = two_product(a.high, b.high);
  return {product.high, product.low + (a.high * b.low + a.low * b.high)};
}

/// Returns the sum of three unnormalised products, not normalised either.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> unnormalised_sum(const DoubleWord<Word>& x,
                                                                        const DoubleWord<Word>& y,
                                                                        const DoubleWord<Word>& z) {
  const DoubleWord<Word> first = two_sum(x.high, y.high), second = two_sum(first.high, z.high);
  return {second.high, (((x.low + y.low) + first.low) + z.low) + second.low};
}

/// Returns a.b, with half the operations of separate products and sums and a third of their latency. Error:
/// bounds::kDot.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> dot(const Vector3<DoubleWord<Word>>& a,
                                                           const Vector3<DoubleWord<Word>>& b) {
  const DoubleWord<Word> x = unnormalised_product(a.x, b.x), y = unnormalised_product(a.y, b.y);
  const DoubleWord<Word> sum = unnormalised_sum(x, y, unnormalised_product(a.z, b.z));
  return two_sum(sum.high, sum.low);
}

/// a b - c d, not normalised. Error: bounds::kCross.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> unnormalised_difference(const DoubleWord<Word>& a,
                                                                               const DoubleWord<Word>& b,
                                                                               const DoubleWord<Word>& c,
                                                                               const DoubleWord<Word>& d) {
  const DoubleWord<Word> first = unnormalised_product(a, b), second = unnormalised_product(c, d);
  const DoubleWord<Word> high = two_difference(first.high, second.high);
  return {high.high, (first.low - second.low) + high.low};
}
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> product_difference(const DoubleWord<Word>& a,
                                                                          const DoubleWord<Word>& b,
                                                                          const DoubleWord<Word>& c,
                                                                          const DoubleWord<Word>& d) {
  const DoubleWord<Word> difference = unnormalised_difference(a, b, c, d);
  return two_sum(difference.high, difference.low);
}

template <class Word>
__attribute__((always_inline)) inline Vector3<DoubleWord<Word>> cross(const Vector3<DoubleWord<Word>>& a,
                                                                      const Vector3<DoubleWord<Word>>& b) {
  return {product_difference(a.y, b.z, a.z, b.y), product_difference(a.z, b.x, a.x, b.z),
          product_difference(a.x, b.y, a.y, b.x)};
}

/// a / b to within bounds::kQuotient of its size. Requires b != 0.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> operator/(const DoubleWord<Word>& a, const DoubleWord<Word>& b) {
  const Word first = a.high / b.high;
  const DoubleWord<Word> after_first = a - b * DoubleWord<Word>(first);
  const Word second = after_first.high / b.high;
  const DoubleWord<Word> after_second = after_first - b * DoubleWord<Word>(second);
  return quick_two_sum(first, second) + DoubleWord<Word>(after_second.high / b.high);
}

/// 1 / b to within bounds::kQuotient of its size, by a step of Newton's method. Requires b != 0.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> reciprocal(const DoubleWord<Word>& b) {
  const Word first = Word(1) / b.high;
  const DoubleWord<Word> product = two_product(b.high, first);
  const Word rest = ((Word(1) - product.high) - product.low) - b.low * first;
  return quick_two_sum(first, first * rest);
}

/// The square root to within bounds::kQuotient of its size. Requires a >= 0.
template <class Word>
__attribute__((always_inline)) inline DoubleWord<Word> sqrt(const DoubleWord<Word>& a) {
  using std::sqrt;
  if (a.high == 0) return {};  // exact: the tail is zero with it
  const Word root = sqrt(a.high);
  const DoubleWord<Word> rest = a - two_product(root, root);
  return quick_two_sum(root, rest.high / (2 * root));
}

/// The double that is nearest to the sum, and has its sign.
__attribute__((always_inline)) inline double leading(const DoubleDouble& a) { return a.high; }
__attribute__((always_inline)) inline double leading(double a) { return a; }

/// Sign of the sum, exact: high decides, as |low| <= |high|.
inline int sign(const DoubleDouble& value) { return (value.high > 0) - (value.high < 0); }

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered::detail

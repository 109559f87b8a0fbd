// SPDX-License-Identifier: GPL-3.0-or-later
// A lone sign (numbers/lane_vector.h) in rationals, word by word: products and sums that are not normalised, and the
// last step, which subtracts high and low parts each for themselves.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <vector>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/proofs/error_bound.h"
#include "robust/proofs/expressions.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs {

// The templates of double_double.h over the bounds of words. The error of a number is the sum of those of its words.

using Words = DoubleWord<ErrorBound>;

/// A rounded operation and its rest, which is exact.
inline Words with_rest(const ErrorBound& exact) {
  ErrorBound high = rounded(exact);
  const mpq_class rest = high.error - exact.error;
  high.error = exact.error;
  return {high, known_within(*exact.model, rest, 0)};
}
inline Words two_sum(const ErrorBound& a, const ErrorBound& b) { return with_rest(exact_sum(a, b)); }
inline Words two_difference(const ErrorBound& a, const ErrorBound& b) { return with_rest(exact_difference(a, b)); }
inline Words two_product(const ErrorBound& a, const ErrorBound& b) { return with_rest(exact_product(a, b)); }

/// The template's operations, and the product of the low words, which they leave out.
inline Words unnormalised_product(const Words& a, const Words& b) {
  Words product = filtered::detail::unnormalised_product<ErrorBound>(a, b);
  product.low.error += (a.low.magnitude() + a.low.error) * (b.low.magnitude() + b.low.error);
  return product;
}

namespace lone_sign {
namespace {

const ErrorModel kWords{kU, 0, true};

/// As LaneVector and Unnormalised.
struct Vector {
  Vector3<Words> of;
};
struct Number {
  Words words;
};
Number dot(const Vector& a, const Vector& b) {
  return {unnormalised_sum(unnormalised_product(a.of.x, b.of.x), unnormalised_product(a.of.y, b.of.y),
                           unnormalised_product(a.of.z, b.of.z))};
}
Vector cross(const Vector& a, const Vector& b) {
  const auto component = [&](int i, int j) { return unnormalised_difference(a.of[i], b.of[j], a.of[j], b.of[i]); };
  return {{component(1, 2), component(2, 0), component(0, 1)}};
}
Number operator*(const Number& a, const Number& b) { return {unnormalised_product(a.words, b.words)}; }

/// Returns which bound a difference needs, in kDoubleDoubleUnit.
///
/// Let d be the difference of the words, and l that of the low ones. What is computed is
/// ((d - l)(1 + d1) + l (1 + d2))(1 + d3) with |di| <= u, which is d (1 + d1)(1 + d3) up to 2 u (1 + u) |l|. If it is
/// larger than (1 + u)^2 times the error of d and that rest, d has the exact sign, and so has what is computed.
mpq_class operator-(const Number& a, const Number& b) {
  const mpq_class low = a.words.low.magnitude() + b.words.low.magnitude();
  const mpq_class error = a.words.high.error + a.words.low.error + b.words.high.error + b.words.low.error;
  return (power(1 + kU, 2) * error + 2 * kU * (1 + kU) * low) / bounds::kDoubleDoubleUnit;
}

struct Sign {
  double constant;
  mpq_class needed;
};

/// The signs on which alone contact may depend, of exact vectors, with maxima of 1.
std::vector<Sign> lone_signs() {
  const auto word = [](const mpq_class& largest) { return known_within(kWords, largest, 0); };
  const Words exact{word(1), word(kU)};
  const Vector to_center{{exact, exact, exact}}, edge = to_center, other = to_center;
  const Number radius{{word(1), word(0)}};
  constexpr int kNormal = 2;  // the maximum of a normal
  return {{bounds::kVertex, signs::vertex(to_center, radius)},
          {bounds::kLine, signs::line(to_center, edge, radius)},
          {bounds::kPlane, signs::plane(signs::normal(edge, other), to_center, radius) / (kNormal * kNormal)}};
}

TEST(LoneSign, NeedsNoMoreThanItsMultipleOfTheConstantWithoutNormalisation) {
  for (const Sign& sign : lone_signs())
    EXPECT_LE(sign.needed, bounds::kUnnormalised * sign.constant - kRoundingOfBound) << sign.constant;
}

TEST(LoneSign, NeedsMoreThanTheConstantOfNormalisedNumbersForLinesAndPlanes) {
  const std::vector<Sign> signs = lone_signs();
  EXPECT_GT(signs[1].needed, signs[1].constant);
  EXPECT_GT(signs[2].needed, 0.875 * bounds::kUnnormalised * signs[2].constant);
}

}  // namespace
}  // namespace lone_sign
}  // namespace touchstone::proofs

// SPDX-License-Identifier: GPL-3.0-or-later
// The bound that Permanent carries, in exact rationals over the same expressions.
#include "robust/filtered/detail/numbers/permanent.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "robust/proofs/expressions.h"
#include "tests/robust/proofs/permanent_inputs.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs {
namespace {

/// The factors that a node's computed value and computed permanent keep within, relative to the exact permanent: the
/// error is at most (upper - 1) M, the computed permanent at least lower M.
struct Factors {
  mpq_class upper, lower;
};
Factors operator+(const Factors& a, const Factors& b) {
  return {std::max(a.upper, b.upper) * (1 + kU), std::min(a.lower, b.lower) * (1 - kU)};
}
Factors operator-(const Factors& a, const Factors& b) { return a + b; }
Factors operator*(const Factors& a, const Factors& b) {
  return {a.upper * b.upper * (1 + kU), a.lower * b.lower * (1 - kU)};
}

TEST(Permanent, CountsTheRoundingsOfEverySign) {
  const auto factors = make_inputs<Factors>([](const Input& input) {
    const std::size_t roundings = input.error == 0 ? 0 : 1;
    return Factors{power(1 + kU, roundings), power(1 - kU, roundings)};
  });
  for_each_claim([&](const Claim& claim, const auto& expression) {
    constexpr int roundings = roundings_of<decltype(expression(PermanentInputs{}))>;
    const Factors result = expression(factors);
    EXPECT_EQ(result.upper, power(1 + kU, roundings)) << claim.constant;
    EXPECT_EQ(result.lower, power(1 - kU, roundings)) << claim.constant;
    EXPECT_LE(roundings, 64) << claim.constant;
  });
}

// The bound of certain_sign: the permanent and two operations may each have been rounded down.
TEST(Permanent, SlackCoversSecondOrderTermsAndTheBoundsOwnRounding) {
  for (std::size_t k = 0; k <= 64; ++k) {
    const mpq_class error = power(1 + kU, k) - 1;
    EXPECT_LE(error, (k + mpq_class(1, 16)) * kU) << k;
    EXPECT_LE(error, (k + mpq_class(1, 8)) * kU * power(1 - kU, k + 2)) << k;
  }
  EXPECT_GT(power(1 + kU, 64) - 1, 64 * kU) << "some slack is needed";
}

// (1+u)^k <= 1 / (1 - k u) and (1-u)^(k+2) >= 1 - (k+2) u; both conditions are hardest for the largest k.
TEST(Permanent, SlackSufficesForAMillionRoundings) {
  const mpq_class k = 1 << 20;
  EXPECT_LE(k * k * kU / (1 - k * kU), mpq_class(1, 16));
  EXPECT_LE((k + mpq_class(1, 8)) * (k + 2) * kU, mpq_class(1, 16));
}

}  // namespace
}  // namespace touchstone::proofs

// SPDX-License-Identifier: GPL-3.0-or-later
// The error that the rounded sums of poses allow for, in rationals over the additions that are compiled.
#include "robust/scene/detail/rounded_sum.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "tests/robust/proofs/permanent_inputs.h"
#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs::rounded_sum {
namespace {

/// What Permanent guarantees of a sum of six doubles, for exact magnitudes of 1 in all: it is off by at most
/// upper - 1, and so are the magnitudes as computed.
constexpr int kRoundings = [] {
  constexpr Permanent<0> d{0, 0};
  return roundings_of<decltype(scene::detail::added_up(d, d, d, d, d, d))>;
}();
const mpq_class kUpper = power(1 + kU, kRoundings), kLower = 2 - kUpper;

/// The least that the computed error, a product by a power of two, may be: underflow takes a sixteenth of it.
mpq_class allowed(const mpq_class& sum_error) { return sum_error * kLower * mpq_class(15, 16); }

/// The sum's own error, and the rounding of sum +- error.
mpq_class needed(const mpq_class& sum_error) { return (kUpper - 1) + kU * (kUpper + sum_error * kUpper); }

TEST(RoundedSum, CoversItsRoundings) {
  EXPECT_EQ(kRoundings, 5);
  EXPECT_LE(needed(scene::detail::kSumError), allowed(scene::detail::kSumError));
  const mpq_class smaller = mpq_class(scene::detail::kSumError) * 3 / 4;
  EXPECT_GT(needed(smaller), allowed(smaller)) << "it is loose";
}

// Magnitudes above 2^-1021: what the product may lose is a sixteenth of it. Others are of at most 53 bits.
TEST(RoundedSum, LosesASixteenthToUnderflow) {
  const mpq_class smallest(1, mpz_class(1) << 1074), magnitudes(1, mpz_class(1) << 1021);
  EXPECT_LE(smallest / 2, mpq_class(scene::detail::kSumError) * magnitudes / 16);
  EXPECT_LE(magnitudes / smallest, mpq_class(mpz_class(1) << 53));
}

}  // namespace
}  // namespace touchstone::proofs::rounded_sum

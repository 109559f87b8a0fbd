// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding of quotients and of their roots: by hand, against MPFR, and against the definition of "nearest".
#include "robust/exact/detail/nearest_double.h"

#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>

#include "experiments/cases/workloads/ulp.h"
#include "tests/robust/support/limits.h"

namespace touchstone::contact_tests {
namespace {

using namespace exact::detail;

mpz_class power_of_two(unsigned exponent) { return mpz_class(1) << exponent; }

TEST(NearestDouble, IsExactWhereTheQuotientIsADouble) {
  EXPECT_EQ(nearest_double(0, 7), 0);
  EXPECT_EQ(nearest_double(6, 3), 2);
  EXPECT_EQ(nearest_double(-3, 8), -0.375);
  EXPECT_EQ(nearest_double(power_of_two(1023), 1), 0x1p1023);
  EXPECT_EQ(nearest_double(1, power_of_two(1074)), kLeast);
}

TEST(NearestDouble, RoundsToTheNearest) {
  EXPECT_EQ(nearest_double(1, 3), 1.0 / 3);
  EXPECT_EQ(nearest_double(-2, 3), -2.0 / 3);
  EXPECT_EQ(nearest_double(1, 10), 0.1);
}

// 2^53 + 1 lies half-way between 2^53 (even) and 2^53 + 2, 2^53 + 3 between 2^53 + 2 and 2^53 + 4 (even).
TEST(NearestDouble, TakesTheEvenOneHalfWay) {
  const mpz_class even = power_of_two(53);
  EXPECT_EQ(nearest_double(even + 1, 1), 0x1p53);
  EXPECT_EQ(nearest_double(even + 3, 1), 0x1p53 + 4);
  EXPECT_EQ(nearest_double(-even - 1, 1), -0x1p53);
  EXPECT_EQ(nearest_double(-even - 3, 1), -0x1p53 - 4);
}

// However little it is: the part cut off must be seen.
TEST(NearestDouble, IsDecidedByTheLeastBitBeyondHalfWay) {
  for (const unsigned bits : {1U, 11U, 12U, 64U, 500U, 3000U}) {
    const mpz_class half_way = (power_of_two(53) + 1) * power_of_two(bits);
    EXPECT_EQ(nearest_double(half_way + 1, power_of_two(bits)), 0x1p53 + 2) << bits;
    EXPECT_EQ(nearest_double(half_way, power_of_two(bits)), 0x1p53) << bits;
    EXPECT_EQ(nearest_double(half_way - 1, power_of_two(bits)), 0x1p53) << bits;
  }
}

TEST(NearestDouble, RoundsToSubnormalsOnce) {
  EXPECT_EQ(nearest_double(3, power_of_two(1075)), 2 * kLeast);  // 1.5: a tie, to even
  EXPECT_EQ(nearest_double(1, power_of_two(1075)), 0);           // 0.5: a tie, to even
  EXPECT_EQ(nearest_double(power_of_two(900) + 1, power_of_two(1975)), kLeast);
  EXPECT_EQ(nearest_double(-1, power_of_two(3000)), 0);
  // 1 + 2^-1 - 2^-60 least doubles: rounding to 53 bits first would make it the tie.
  EXPECT_EQ(nearest_double(3 * power_of_two(59) - 1, power_of_two(59 + 1075)), kLeast);
}

TEST(NearestDouble, IsPositiveZeroWhereItRoundsToZero) {
  for (const mpz_class& numerator : {mpz_class(0), mpz_class(1), mpz_class(-1)})
    EXPECT_FALSE(std::signbit(nearest_double(numerator, power_of_two(1076)))) << numerator;
  EXPECT_EQ(nearest_double(-3, power_of_two(1075)), -2 * kLeast);
}

TEST(NearestDouble, RoundsToInfinityFromHalfAStepBeyondTheLargest) {
  const mpz_class half_step = power_of_two(970), beyond = power_of_two(1024) - half_step;
  EXPECT_EQ(nearest_double(beyond - 1, 1), kMax);
  EXPECT_EQ(nearest_double(beyond, 1), kInfinity);
  EXPECT_EQ(nearest_double(-beyond, 1), -kInfinity);
  EXPECT_EQ(nearest_root(beyond * beyond - 1, 1), kMax);
  EXPECT_EQ(nearest_root(beyond * beyond, 1), kInfinity);
}

TEST(NearestRoot, IsExactForSquares) {
  EXPECT_EQ(nearest_root(0, 1), 0);
  EXPECT_EQ(nearest_root(9, 16), 0.75);
  EXPECT_EQ(nearest_root(power_of_two(2046), 1), 0x1p1023);
  EXPECT_EQ(nearest_root(1, power_of_two(2148)), kLeast);
  EXPECT_EQ(nearest_root(2, 1), std::sqrt(2.0));
  EXPECT_EQ(nearest_root(1, 2), std::sqrt(0.5));
}

TEST(NearestRoot, IsDecidedByTheLeastBitBeyondHalfWay) {
  const mpz_class half_way = (power_of_two(53) + 1) * power_of_two(300), square = half_way * half_way;
  EXPECT_EQ(nearest_root(square - 1, power_of_two(600)), 0x1p53);
  EXPECT_EQ(nearest_root(square, power_of_two(600)), 0x1p53);
  EXPECT_EQ(nearest_root(square + 1, power_of_two(600)), 0x1p53 + 2);
  EXPECT_EQ(nearest_root(3 * square + 1, 3 * power_of_two(600)), 0x1p53 + 2);  // cut off in the division
}

TEST(NearestDouble, DoesNotDependOnTheRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const std::array<double, 5> results{nearest_double(1, 3), nearest_double(-1, 3), nearest_root(2, 1),
                                        nearest_double(3, power_of_two(1075)), nearest_double(power_of_two(1024), 1)};
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(results, (std::array<double, 5>{1.0 / 3, -1.0 / 3, std::sqrt(2.0), 2 * kLeast, kInfinity})) << mode;
  }
}

/// An integer of up to 2000 bits, often with few ones or zeros.
rc::Gen<std::string> integers() {
  return rc::gen::exec([] {
    const auto bits = [] { return *rc::gen::resize(100, rc::gen::inRange(0U, 1200U)); };
    mpz_class value = *rc::gen::inRange(0, 1 << 20);
    value = value * power_of_two(bits()) + *rc::gen::inRange(-3, 4);
    value = value * power_of_two(*rc::gen::element(0U, bits())) + *rc::gen::inRange(-1, 2);
    return mpz_class(abs(value) + 1).get_str();
  });
}

/// Numerator / denominator by MPFR's own division, in the format of doubles.
double by_mpfr(const mpz_class& numerator, const mpz_class& denominator) {
  mpfr_t n, d, quotient;
  mpfr_inits2(10000, n, d, static_cast<mpfr_ptr>(nullptr));
  mpfr_init2(quotient, 53);
  mpfr_set_z(n, numerator.get_mpz_t(), MPFR_RNDN);
  mpfr_set_z(d, denominator.get_mpz_t(), MPFR_RNDN);
  const mpfr_exp_t emin = mpfr_get_emin(), emax = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  const int rounded = mpfr_div(quotient, n, d, MPFR_RNDN);
  mpfr_subnormalize(quotient, rounded, MPFR_RNDN);
  const double result = mpfr_get_d(quotient, MPFR_RNDN);
  mpfr_set_emin(emin);
  mpfr_set_emax(emax);
  mpfr_clears(n, d, quotient, static_cast<mpfr_ptr>(nullptr));
  return result;
}

RC_GTEST_PROP(NearestDouble, IsThatOfMpfr, ()) {
  const mpz_class numerator(*integers()), denominator(*integers());
  RC_ASSERT(nearest_double(numerator, denominator) == by_mpfr(numerator, denominator));
  RC_ASSERT(nearest_double(-numerator, denominator) == -by_mpfr(numerator, denominator));
}

/// The middle between a finite double and its neighbour above.
mpq_class middle_above(double x) { return (mpq_class(x) + mpq_class(workloads::move_by_doubles(x, 1))) / 2; }

// By definition: no farther from the root than the middles to both neighbours; on a middle only if even.
RC_GTEST_PROP(NearestRoot, LiesBetweenTheMiddlesToItsNeighbours, ()) {
  const mpz_class numerator(*integers()), denominator(*integers());
  mpq_class square(numerator, denominator);
  square.canonicalize();
  const double root = nearest_root(numerator, denominator);
  RC_PRE(root > 0 && root < kMax);
  const mpq_class low = middle_above(workloads::move_by_doubles(root, -1)), high = middle_above(root);
  const bool even = workloads::ordinal(root) % 2 == 0;
  const bool above_low = low * low < square || (even && low * low == square);
  const bool below_high = square < high * high || (even && square == high * high);
  RC_ASSERT(above_low);
  RC_ASSERT(below_high);
}

RC_GTEST_PROP(NearestRoot, IsExactForSquaresOfDoubles, ()) {
  const double root = std::abs(*rc::gen::arbitrary<double>());
  RC_PRE(std::isfinite(root));
  const mpq_class square = mpq_class(root) * mpq_class(root);
  RC_ASSERT(nearest_root(square.get_num(), square.get_den()) == root);
}

/// Compares (term + sign sqrt(radicand)) / denominator with a number: -1, 0 or 1.
int compare_sum(const mpz_class& term, int sign, const mpz_class& radicand, const mpz_class& denominator,
                const mpq_class& number) {
  const mpq_class rest = number * denominator - term;  // against sign sqrt(radicand)
  const int root_sign = radicand == 0 ? 0 : sign;
  if (sgn(rest) != root_sign) return root_sign > sgn(rest) ? 1 : -1;
  const mpq_class rest_squared = rest * rest, root_squared = radicand;
  return root_sign * (root_squared > rest_squared ? 1 : root_squared < rest_squared ? -1 : 0);
}

// By definition, too; nearly equal terms of opposite signs cancel.
RC_GTEST_PROP(NearestSumWithRoot, LiesBetweenTheMiddlesToItsNeighbours, ()) {
  const mpz_class denominator(*integers()), any_radicand(*integers());
  const int sign = *rc::gen::inRange(-1, 2);
  mpz_class term(*integers());
  if (*rc::gen::arbitrary<bool>()) term = -term;
  mpz_class radicand = any_radicand;
  if (*rc::gen::arbitrary<bool>()) radicand = term * term + *rc::gen::inRange(-2, 3);
  RC_PRE(radicand >= 0);
  const double sum = nearest_sum_with_root(term, sign, radicand, denominator);
  const auto against = [&](const mpq_class& number) { return compare_sum(term, sign, radicand, denominator, number); };
  RC_PRE(std::abs(sum) < kMax);
  RC_ASSERT(sum != 0 || !std::signbit(sum));
  const int low = against(middle_above(workloads::move_by_doubles(sum, -1))), high = against(middle_above(sum));
  const bool even = workloads::ordinal(sum) % 2 == 0;
  RC_ASSERT(low > 0 || (even && low == 0));
  RC_ASSERT(high < 0 || (even && high == 0));
}

TEST(NearestSumWithRoot, IsThatOfHand) {
  EXPECT_EQ(nearest_sum_with_root(1, 1, 4, 1), 3);
  EXPECT_EQ(nearest_sum_with_root(1, -1, 4, 1), -1);
  EXPECT_EQ(nearest_sum_with_root(-1, -1, 4, 3), -1);
  EXPECT_EQ(nearest_sum_with_root(5, 0, 4, 2), 2.5);
  EXPECT_EQ(nearest_sum_with_root(0, -1, 2, 1), -std::sqrt(2.0));
  EXPECT_EQ(nearest_sum_with_root(1, 1, 5, 2), 1.618033988749895);
  EXPECT_EQ(nearest_sum_with_root(3, -1, 3, 4), 0.3169872981077807);
  for (const double zero : {nearest_sum_with_root(2, -1, 4, 7), nearest_sum_with_root(-2, 1, 4, 7),
                            nearest_sum_with_root(0, 1, 0, 1), nearest_sum_with_root(-1, 0, 9, power_of_two(1080))}) {
    EXPECT_EQ(zero, 0);
    EXPECT_FALSE(std::signbit(zero));
  }
}

// 2^600 - sqrt(2^1200 - 1) is about 2^-601.
TEST(NearestSumWithRoot, SurvivesCancellation) {
  EXPECT_EQ(nearest_sum_with_root(power_of_two(600), -1, power_of_two(1200) - 1, 1), 0x1p-601);
  EXPECT_EQ(nearest_sum_with_root(-power_of_two(600), 1, power_of_two(1200) - 1, 1), -0x1p-601);
}

// A value just beside the middle of two doubles, on either side of it.
TEST(NearestSumWithRoot, TellsTheSidesOfAMiddle) {
  // Doubles from 2^53 on are even. 2^53 + 1 plus and minus a difference of about 2^-601; the tie itself goes to even.
  const mpz_class near_root = power_of_two(1200) + 1, term = power_of_two(53) + 1 - power_of_two(600);
  EXPECT_EQ(nearest_sum_with_root(term, 1, near_root, 1), 0x1p53 + 2);
  EXPECT_EQ(nearest_sum_with_root(-term, -1, near_root, 1), -0x1p53 - 2);
  EXPECT_EQ(nearest_sum_with_root(term, 1, near_root - 1, 1), 0x1p53);
  EXPECT_EQ(nearest_sum_with_root(term, 1, near_root - 2, 1), 0x1p53);
  EXPECT_EQ(nearest_sum_with_root(term + 2, 1, near_root - 1, 1), 0x1p53 + 4);
  EXPECT_EQ(nearest_sum_with_root(term + 2, 1, near_root - 2, 1), 0x1p53 + 2);
  EXPECT_EQ(nearest_sum_with_root(power_of_two(53) + 3 + power_of_two(600), -1, near_root, 1), 0x1p53 + 2);
}

TEST(NearestSumWithRoot, DoesNotDependOnTheRoundingMode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const double golden = nearest_sum_with_root(1, 1, 5, 2), negative = nearest_sum_with_root(1, -1, 5, 2);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(golden, 1.618033988749895) << mode;
    EXPECT_EQ(negative, -0.6180339887498949) << mode;
  }
}

}  // namespace
}  // namespace touchstone::contact_tests

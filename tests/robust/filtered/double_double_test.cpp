// SPDX-License-Identifier: GPL-3.0-or-later
// Error-free transformations against rationals; double-doubles within the unit that the bounds rest on.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "tests/robust/filtered/exact_number.h"

namespace touchstone::filtered_tests {
namespace {

using filtered::detail::DoubleDouble;
using workloads::move_by_doubles;
using workloads::Random;

constexpr std::uint64_t kPairs = 1000 * TOUCHSTONE_SAMPLES;

/// All bits, few bits, powers of two and their neighbours, zero; of magnitude 2^-reach to 2^reach.
double number(Random& random, int reach) {
  const double x = random.log_uniform(-reach, reach);
  const double power = std::copysign(std::ldexp(1.0, std::ilogb(x)), x);
  switch (random.integer(0, 5)) {
    case 0: return power;
    case 1: return move_by_doubles(power, random.integer(-2, 2));
    case 2: return std::nearbyint(x / power * 0x1p26) * (power * 0x1p-26);
    case 3: return random.integer(0, 9) == 0 ? 0 : x;
    default: return x;
  }
}

/// Two numbers, often of nearly the same magnitude.
struct Pair {
  double a, b;
};
Pair pair(std::uint64_t index, int reach) {
  Random random(2008, index);
  const double a = number(random, reach);
  if (random.coin()) return {a, number(random, reach)};
  const double b = move_by_doubles(a, random.integer(-5, 5));
  return {a, random.coin() ? b : -b};
}

bool is_normalised(const DoubleDouble& x) { return x.high + x.low == x.high; }

TEST(FilteredErrorFree, SumsAreExact) {
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const auto [a, b] = pair(i, 900);
    const DoubleDouble sum = filtered::detail::two_sum(a, b), difference = filtered::detail::two_difference(a, b);
    EXPECT_EQ(exactly(sum), exactly(a) + exactly(b)) << "index " << i;
    EXPECT_EQ(sum.high, a + b) << "index " << i;
    EXPECT_EQ(exactly(difference), exactly(a) - exactly(b)) << "index " << i;
    const double large = std::max(std::abs(a), std::abs(b)), small = std::min(std::abs(a), std::abs(b));
    EXPECT_EQ(exactly(filtered::detail::quick_two_sum(large, -small)), exactly(large) - exactly(small))
        << "index " << i;
  }
}

TEST(FilteredErrorFree, ProductsAreExact) {
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    const auto [a, b] = pair(i, 450);
    const DoubleDouble product = filtered::detail::two_product(a, b);
    EXPECT_EQ(exactly(product), exactly(a) * exactly(b)) << "index " << i;
    EXPECT_EQ(product.high, a * b) << "index " << i;
  }
}

/// Of every shape: a low part that is zero, least, as large as may be, of either sign.
DoubleDouble double_double(Random& random, int reach) {
  const double high = number(random, reach);
  switch (random.integer(0, 3)) {
    case 0: return high;
    case 1: return filtered::detail::two_sum(high, high * 0x1p-53 * (2 * random.unit() - 1));
    case 2:
      return filtered::detail::two_sum(
          high, std::copysign(std::ldexp(1.0, std::ilogb(high == 0 ? 1 : high) - 54), random.coin() ? 1 : -1));
    default: return filtered::detail::two_sum(high, high * random.log_uniform(-100, -54));
  }
}

void expect_within_unit(const DoubleDouble& computed, const mpq_class& exact, const char* operation,
                        std::uint64_t index) {
  const mpq_class error = abs(exactly(computed) - exact);
  EXPECT_LE(error, abs(exact) * exactly(filtered::detail::bounds::kDoubleDoubleUnit))
      << operation << ", index " << index;
  EXPECT_TRUE(is_normalised(computed)) << operation << ", index " << index;
  EXPECT_EQ(sign(computed), sgn(exact)) << operation << ", index " << index;
}

TEST(FilteredDoubleDouble, OperationsAreWithinTheirUnit) {
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    Random random(2009, i);
    const DoubleDouble a = double_double(random, 100);
    DoubleDouble b = double_double(random, 100);
    if (random.integer(0, 2) == 0) b = {a.high, move_by_doubles(a.low, random.integer(-3, 3))};  // almost cancels
    if (random.integer(0, 7) == 0) b = {move_by_doubles(a.high, random.integer(-2, 2)), -a.low};
    if (!is_normalised(b)) continue;
    expect_within_unit(a + b, exactly(a) + exactly(b), "+", i);
    expect_within_unit(a - b, exactly(a) - exactly(b), "-", i);
    expect_within_unit(a * b, exactly(a) * exactly(b), "*", i);
    EXPECT_EQ(exactly(-a), -exactly(a)) << "index " << i;
  }
}

/// |computed / exact - 1| asked without a root: squares are compared.
TEST(FilteredDoubleDouble, QuotientsAndRootsAreWithinTheirBounds) {
  const mpq_class unit =
      exactly(filtered::detail::bounds::kQuotient) * exactly(filtered::detail::bounds::kDoubleDoubleUnit);
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    Random random(2010, i);
    const DoubleDouble a = double_double(random, 100), b = double_double(random, 100);
    if (b.high == 0) continue;
    const mpq_class exact = exactly(a) / exactly(b), quotient = exactly(a / b);
    EXPECT_LE(abs(quotient - exact), abs(exact) * unit) << "/, index " << i;
    EXPECT_TRUE(is_normalised(a / b)) << "/, index " << i;

    EXPECT_LE(abs(exactly(reciprocal(b)) * exactly(b) - 1), unit) << "1 / b, index " << i;
    EXPECT_TRUE(is_normalised(reciprocal(b))) << "1 / b, index " << i;

    const DoubleDouble positive = a.high < 0 ? -a : a;
    const mpq_class root = exactly(sqrt(positive));
    EXPECT_GE(root, 0) << "sqrt, index " << i;
    EXPECT_LE(root * root, exactly(positive) * (1 + unit) * (1 + unit)) << "sqrt, index " << i;
    EXPECT_GE(root * root, exactly(positive) * (1 - unit) * (1 - unit)) << "sqrt, index " << i;
    EXPECT_TRUE(is_normalised(sqrt(positive))) << "sqrt, index " << i;
  }
}

}  // namespace
}  // namespace touchstone::filtered_tests

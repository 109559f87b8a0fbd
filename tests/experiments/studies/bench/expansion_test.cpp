// SPDX-License-Identifier: GPL-3.0-or-later
// Expansions against rationals.
#include "experiments/studies/bench/expansion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cases/workloads/random.h"

namespace touchstone::bench {
namespace {

mpq_class value_of(const Expansion& a) {
  mpq_class sum(0);
  for (int i = 0; i < a.size(); ++i) sum += mpq_class(a.word(i));
  return sum;
}

void expect_ordered(const Expansion& a) {
  for (int i = 0; i < a.size(); ++i) EXPECT_NE(a.word(i), 0);
  for (int i = 1; i < a.size(); ++i) EXPECT_LT(std::abs(a.word(i - 1)), std::abs(a.word(i)));
}

TEST(Expansion, IsExact) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    workloads::Random random(1, i);
    const auto draw = [&random] { return random.log_uniform(-30, 30); };
    const double x = draw(), y = draw(), z = draw();
    const Expansion a = exact_difference(x, y), b = exact_difference(z, i % 2 == 0 ? draw() : std::nextafter(z, x));
    const auto product = a * b;
    const auto difference = product * product - a * (b * b);
    const auto zero = product * product - (a * a) * (b * b);
    expect_ordered(product);
    expect_ordered(difference);
    const mpq_class p = value_of(a) * value_of(b), d = p * p - value_of(a) * value_of(b) * value_of(b);
    EXPECT_EQ(value_of(a), mpq_class(mpq_class(x) - mpq_class(y)));
    EXPECT_EQ(value_of(product), p);
    EXPECT_EQ(value_of(difference), d);
    EXPECT_EQ(sign(difference), sgn(d));
    EXPECT_EQ(sign(zero), 0);
    EXPECT_EQ(value_of(a + b), mpq_class(value_of(a) + value_of(b)));
  }
}

}  // namespace
}  // namespace touchstone::bench

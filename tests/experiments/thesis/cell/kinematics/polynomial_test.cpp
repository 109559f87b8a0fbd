// SPDX-License-Identifier: GPL-3.0-or-later
// Real roots of integer polynomials: as many as were put in, where they were put, simple or not.
#include "experiments/thesis/cell/first_contact/polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "experiments/cases/workloads/random.h"

namespace touchstone::kinematics {
namespace {

using workloads::Random;

Polynomial polynomial(const std::vector<long>& coefficients) {
  return Polynomial(std::vector<mpz_class>(coefficients.begin(), coefficients.end()));
}

mpq_class value_of(const Dyadic& x) { return mpq_class(x.numerator) / (mpz_class(1) << x.shift); }

// Planted: a count that takes in the lower end, a half of an interval that is not looked at, (a, b) for (a, b].
TEST(RealRoots, AreThoseOfTheFactors) {
  const Dyadic end{2, 0};
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 92);
    Polynomial product = polynomial({random.coin() ? 1 : -3});
    std::multiset<mpq_class> expected;
    const auto count = random.integer(1, 4);
    for (int i = 0; i < count; ++i) {
      // Small numbers: roots meet, and stand at 0, at 2 and at points where intervals are halved.
      const long p = random.integer(-3, 12), q = random.integer(1, 6);
      product = product * polynomial({-p, q});
      if (p > 0 && p <= 2 * q) expected.insert(mpq_class(p, static_cast<unsigned long>(q)));
    }
    if (random.integer(0, 3) == 0) product = product * polynomial({3, 1, 1});  // no real root
    for (auto& root : std::multiset<mpq_class>(expected)) (void)root;
    std::set<mpq_class> different;
    for (mpq_class root : expected) root.canonicalize(), different.insert(root);

    std::vector<Root> roots = real_roots(product, end);
    ASSERT_EQ(roots.size(), different.size()) << "sample " << index;
    auto at = different.begin();
    for (Root& root : roots) {
      const mpq_class value = *at++;
      EXPECT_TRUE(value_of(root.low()) <= value && value <= value_of(root.high())) << "sample " << index;
      root.refine(100);
      EXPECT_TRUE(value_of(root.low()) <= value && value <= value_of(root.high())) << "sample " << index;
      EXPECT_LE(mpq_class(value_of(root.high()) - value_of(root.low())), mpq_class(1) / (mpz_class(1) << 100));
      std::size_t times = 0;
      for (mpq_class other : expected) other.canonicalize(), times += other == value ? 1U : 0U;
      EXPECT_EQ(root.multiple(), times > 1) << "sample " << index;
    }
  }
}

TEST(RealRoots, OfConstantsAreNone) {
  EXPECT_TRUE(real_roots(Polynomial(), {1, 0}).empty());
  EXPECT_TRUE(real_roots(polynomial({5}), {1, 0}).empty());
}

// sqrt(2) and polynomials that vanish there, or pass by at 2^-70, 2^-200 and 2^-3000.
TEST(RootSign, IsExactHoweverNearTheRootIs) {
  const auto root_of_two = [] { return real_roots(polynomial({-2, 0, 1}), {2, 0}).front(); };
  EXPECT_EQ(root_of_two().sign_of(polynomial({-2, 0, 1}) * polynomial({7, -3, 1})), 0);
  EXPECT_EQ(root_of_two().sign_of(polynomial({0, -2, 0, 1})), 0);
  EXPECT_EQ(root_of_two().sign_of(polynomial({-7, 5})), 1);
  EXPECT_EQ(root_of_two().sign_of(polynomial({-17, 12})), -1);
  EXPECT_EQ(root_of_two().sign_of(Polynomial()), 0);
  EXPECT_EQ(root_of_two().sign_of(polynomial({-4})), -1);
  for (const unsigned bits : {70U, 200U, 3000U}) {
    const mpz_class scale = mpz_class(1) << bits;
    for (const int direction : {-1, 1}) {
      const Polynomial near({mpz_class(-2 * scale + direction), mpz_class(0), scale});  // x^2 = 2 - direction 2^-bits
      EXPECT_EQ(root_of_two().sign_of(near), direction) << bits;
    }
  }
}

}  // namespace
}  // namespace touchstone::kinematics

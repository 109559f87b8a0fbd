// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/clopper_pearson.h"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::statistics {
namespace {

constexpr double kFourDigits = 5e-5;

// Tabulated values, such as those of R's binom.test.
TEST(ClopperPearson, KnownLimits) {
  const Limits none = clopper_pearson(0, 10), half = clopper_pearson(5, 10), all = clopper_pearson(10, 10);
  EXPECT_EQ(none.lower, 0);
  EXPECT_NEAR(none.upper, 0.3085, kFourDigits);
  EXPECT_NEAR(half.lower, 0.1871, kFourDigits);
  EXPECT_NEAR(half.upper, 0.8129, kFourDigits);
  EXPECT_NEAR(all.lower, 0.6915, kFourDigits);
  EXPECT_EQ(all.upper, 1);
}

// No failure in n: (1 - upper)^n is the tail.
TEST(ClopperPearson, NoFailuresInManyTrials) {
  constexpr std::uint64_t kTrials = 1'000'000;
  const double upper = clopper_pearson(0, kTrials).upper;
  EXPECT_NEAR(std::pow(1 - upper, static_cast<double>(kTrials)), 0.025, 1e-6);
}

TEST(ClopperPearson, NoTrialsSayNothing) {
  const Limits limits = clopper_pearson(0, 0);
  EXPECT_EQ(limits.lower, 0);
  EXPECT_EQ(limits.upper, 1);
}

TEST(ClopperPearson, HoldTheObservedRate) {
  constexpr std::uint64_t kTrials = 37;
  for (std::uint64_t failures = 0; failures <= kTrials; ++failures) {
    const Limits limits = clopper_pearson(failures, kTrials);
    const double rate = static_cast<double>(failures) / static_cast<double>(kTrials);
    EXPECT_LE(limits.lower, rate);
    EXPECT_GE(limits.upper, rate);
  }
}

}  // namespace
}  // namespace touchstone::statistics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/bounded_mean.h"

#include <gtest/gtest.h>

#include <array>

namespace touchstone::statistics {
namespace {

TEST(BoundedMean, AgreesWithClopperAndPearsonAtBothEnds) {
  for (const std::uint64_t samples : {1U, 10U, 1000U}) {
    EXPECT_EQ(bounded_mean(0, samples).lower, 0);
    EXPECT_NEAR(bounded_mean(0, samples).upper, clopper_pearson(0, samples).upper, 1e-12);
    EXPECT_EQ(bounded_mean(1, samples).upper, 1);
    EXPECT_NEAR(bounded_mean(1, samples).lower, clopper_pearson(samples, samples).lower, 1e-12);
  }
}

TEST(BoundedMean, IsWiderThanForIndependentAnswers) {
  for (const std::uint64_t failures : {1U, 3U, 20U, 39U}) {
    const double mean = static_cast<double>(failures) / 40;
    const auto here = bounded_mean(mean, 40), binomial = clopper_pearson(failures, 40);
    EXPECT_LT(here.lower, binomial.lower) << failures;
    EXPECT_GT(here.upper, binomial.upper) << failures;
    EXPECT_LT(here.lower, mean);
    EXPECT_GT(here.upper, mean);
  }
}

// Where KL(0.5 || m') = log(40) / 100; by hand: m' (1 - m') = exp(-2 log(40) / 100) / 4.
TEST(BoundedMean, SolvesItsEquation) {
  const auto limits = bounded_mean(0.5, 100);
  EXPECT_NEAR(limits.lower, 1 - limits.upper, 1e-12);
  EXPECT_NEAR(limits.lower * limits.upper, 0.25 * 0.92887, 1e-5);
}

TEST(BoundedMean, KnowsNothingWithoutSamples) {
  EXPECT_EQ(bounded_mean(0, 0).lower, 0);
  EXPECT_EQ(bounded_mean(0, 0).upper, 1);
}

}  // namespace
}  // namespace touchstone::statistics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/statistics/shares.h"

#include <gtest/gtest.h>

#include <array>
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

TEST(Percent, IsRoundedWhereThatMisleadsNobody) {
  EXPECT_EQ(percent_to_places(0.5, 0), "50");
  EXPECT_EQ(percent_to_places(0.12345, 2), "12.35");
  EXPECT_EQ(percent_to_places(1.6349, 1), "163.5");
  EXPECT_EQ(percent_to_digits(0.12345, 3), "12.3");
  EXPECT_EQ(percent_to_digits(3.2e-6, 2), "0.00032");
}

TEST(Percent, IsHundredOrZeroOnlyWhereItIs) {
  for (const int places : {0, 1, 3}) {
    EXPECT_EQ(percent_to_places(0, places), "0");
    EXPECT_EQ(percent_to_places(1, places), "100");
  }
  EXPECT_EQ(percent_to_digits(0, 2), "0");
  EXPECT_EQ(percent_to_digits(1, 2), "100");
  EXPECT_EQ(percent_to_places(0.9999, 0), ">99");
  EXPECT_EQ(percent_to_places(0.9999, 1), ">99.9");
  EXPECT_EQ(percent_to_places(std::nextafter(1.0, 0.0), 2), ">99.99");
  EXPECT_EQ(percent_to_places(0.004, 0), "<1");
  EXPECT_EQ(percent_to_places(0.00004, 2), "<0.01");
  EXPECT_EQ(percent_to_places(5e-324, 3), "<0.001");
}

// 1,228 of 1,229 polygons failed.
TEST(Percent, OfAllButOneIsNotAll) {
  EXPECT_EQ(percent_to_digits(share_of(1228, 1229), 2), "99.9");
  EXPECT_EQ(percent_to_digits(share_of(1228, 1229), 3), "99.9");
  EXPECT_EQ(percent_to_digits(share_of(122'899, 122'900), 2), ">99.9");
  EXPECT_EQ(percent_to_digits(share_of(122'899, 122'900), 4), ">99.99");
}

TEST(Percent, OfNothingIsNothing) { EXPECT_EQ(percent_to_places(share_of(0, 0), 2), "0"); }

}  // namespace
}  // namespace touchstone::statistics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/statistics/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "experiments/cases/workloads/random.h"
#include "experiments/program/state.h"

namespace touchstone::statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Units, AreThoseOfTheExactValue) {
  EXPECT_EQ(unit_in_last_place(1), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(-1.999), 0x1p-52);
  EXPECT_EQ(unit_in_last_place(2), 0x1p-51);
  EXPECT_EQ(unit_in_last_place(0), 0x1p-1074);
  EXPECT_EQ(unit_in_last_place(0x1p-1022), 0x1p-1074);
  EXPECT_EQ(unit_in_last_place(0x1p-1021), 0x1p-1073);
  EXPECT_EQ(number_error(3, 3), 0);
  EXPECT_EQ(number_error(std::nextafter(3.0, 4.0), 3), 1);
  EXPECT_EQ(number_error(std::nextafter(3.0, 0.0), 3), 1);
  EXPECT_EQ(number_error(std::nan(""), 3), kInfinity);
  EXPECT_EQ(number_error(kInfinity, 3), kInfinity);
}

// In the largest coordinate a unit counts one, in a coordinate near 0 next to nothing.
TEST(Units, OfAPointAreThoseOfItsLargestCoordinate) {
  const Eigen::Vector3d exact(1e-10, -4, 2);
  EXPECT_EQ(point_error(exact, exact), 0);
  EXPECT_EQ(point_error({1e-10, std::nextafter(-4.0, -5.0), 2}, exact), 1);
  EXPECT_EQ(point_error({1e-10, -4, std::nextafter(2.0, 3.0)}, exact), 0.5);
  EXPECT_LT(point_error({std::nextafter(1e-10, 1.0), -4, 2}, exact), 1e-9);
  EXPECT_EQ(point_error({1e-10, -4, std::nan("")}, exact), kInfinity);
}

Distribution of(std::initializer_list<double> numbers) {
  Distribution distribution;
  for (const double number : numbers) distribution.add(number);
  return distribution;
}

TEST(Distribution, QuantilesOfFewWholeNumbersAreThoseNumbers) {
  const Distribution numbers = of({3, 0, 1, 2});
  EXPECT_EQ(numbers.quantile(0), 0);
  EXPECT_EQ(numbers.quantile(0.25), 0);
  EXPECT_EQ(numbers.quantile(0.5), 1);
  EXPECT_EQ(numbers.quantile(0.51), 2);
  EXPECT_EQ(numbers.quantile(0.99), 3);
  EXPECT_EQ(numbers.quantile(1), 3);
  EXPECT_EQ(of({127}).quantile(0.5), 127);
}

TEST(Distribution, CutsNumbersByLessThanASixtyFourth) {
  workloads::Random random(7, 0);
  for (int i = 0; i < 1000; ++i) {
    const auto exponent = static_cast<int>(random.integer(-1000, 1000));
    const double number = std::ldexp(1 + random.unit(), exponent);
    const Distribution one = of({number, kInfinity});
    EXPECT_LE(one.quantile(0.5), number);
    EXPECT_GT(one.quantile(0.5), number * (1 - 1.0 / 64));
    EXPECT_EQ(of({number}).quantile(1), number);
  }
}

TEST(Distribution, CountsZerosAndInfinitiesApart) {
  const Distribution numbers = of({0, -0.0, 0x1p-1000, 1e308, kInfinity});
  EXPECT_EQ(numbers.count(), 5U);
  EXPECT_EQ(numbers.zeros(), 2U);
  EXPECT_EQ(numbers.infinite(), 1U);
  EXPECT_EQ(numbers.largest(), kInfinity);
  EXPECT_EQ(Distribution().count(), 0U);
}

TEST(Distribution, SumsHoldAllNumbersOfBoth) {
  Distribution sum = of({1, 5});
  sum += of({5, 0.3, kInfinity});
  EXPECT_EQ(sum, of({0.3, kInfinity, 5, 1, 5}));
}

TEST(Distribution, PassesThroughAnArchive) {
  const Distribution numbers = of({0, 0.3, 0.3, 0x1p-1074, kInfinity});
  Distribution read;
  program::restore(program::archived(numbers), read);
  EXPECT_EQ(read, numbers);
}

}  // namespace
}  // namespace touchstone::statistics

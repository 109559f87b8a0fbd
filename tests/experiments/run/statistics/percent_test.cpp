// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/percent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::statistics {
namespace {

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

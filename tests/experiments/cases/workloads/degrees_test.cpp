// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/degrees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touchstone::workloads {
namespace {

TEST(Degrees, AreExactAtQuarterTurns) {
  for (const int turn : {-2, 0, 1, 1000}) {
    EXPECT_EQ(sine(360.0 * turn + 90), 1);
    EXPECT_EQ(cosine(360.0 * turn + 90), 0);
    EXPECT_EQ(sine(360.0 * turn + 30), 0.5);
    EXPECT_EQ(sine(360.0 * turn + 180), 0);
    EXPECT_EQ(cosine(360.0 * turn - 120), -0.5);
    EXPECT_FALSE(std::signbit(sine(-180.0)));
  }
  EXPECT_EQ(arc_sine(0.5), 30);
  EXPECT_EQ(arc_cosine(-1), 180);
  EXPECT_EQ(arc_tangent(-1, -1), -135);
  EXPECT_EQ(arc_tangent(0, -1), 180);
  EXPECT_EQ(arc_tangent(0, 0), 0);
}

// More angles than are remembered, each asked twice, among others and at once.
TEST(Degrees, AreRememberedForTheirOwnAngleAlone) {
  for (int pass = 0; pass < 2; ++pass)
    for (int i = -3000; i <= 3000; ++i) {
      const double angle = 0.07 * i, radians = angle / 180 * std::numbers::pi;
      for (int twice = 0; twice < 2; ++twice) {
        ASSERT_NEAR(sine(angle), std::sin(radians), 1e-14) << angle;
        ASSERT_NEAR(cosine(angle), std::cos(radians), 1e-14) << angle;
      }
    }
}

}  // namespace
}  // namespace touchstone::workloads

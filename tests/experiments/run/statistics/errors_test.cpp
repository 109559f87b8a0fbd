// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/statistics/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace touchstone::statistics {
namespace {

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
  EXPECT_EQ(number_error(std::nan(""), 3), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number_error(std::numeric_limits<double>::infinity(), 3), std::numeric_limits<double>::infinity());
}

// In the largest coordinate a unit counts one, in a coordinate near 0 next to nothing.
TEST(Units, OfAPointAreThoseOfItsLargestCoordinate) {
  const Eigen::Vector3d exact(1e-10, -4, 2);
  EXPECT_EQ(point_error(exact, exact), 0);
  EXPECT_EQ(point_error({1e-10, std::nextafter(-4.0, -5.0), 2}, exact), 1);
  EXPECT_EQ(point_error({1e-10, -4, std::nextafter(2.0, 3.0)}, exact), 0.5);
  EXPECT_LT(point_error({std::nextafter(1e-10, 1.0), -4, 2}, exact), 1e-9);
  EXPECT_EQ(point_error({1e-10, -4, std::nan("")}, exact), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace touchstone::statistics

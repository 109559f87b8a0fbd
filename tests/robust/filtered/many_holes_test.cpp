// SPDX-License-Identifier: GPL-3.0-or-later
// More loops than a node of the hierarchy has children: whole loops are told from the foot without a look at them.
#include <gtest/gtest.h>

#include <vector>

#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/support/printing.h"

namespace touchstone::filtered_tests {
namespace {

/// A square of side 4 `count`, seen from above, in a plane of slope 1/2, with count x count square holes of side 2.
Polygon sieve(int count) {
  const auto square = [](double x, double y, double side) {
    const auto place = [](double u, double v) { return Eigen::Vector3d(u, v, u / 2); };
    return Loop{place(x, y), place(x + side, y), place(x + side, y + side), place(x, y + side)};
  };
  std::vector<Loop> holes;
  for (int row = 0; row < count; ++row)
    for (int column = 0; column < count; ++column) holes.push_back(square(4 * column + 1, 4 * row + 1, 2));
  return Polygon(square(0, 0, 4 * count), holes);
}

// Every answer is that of exact: the foot on rims, in holes, between them, outside, level with loops or with none.
TEST(FilteredManyHoles, AreAnsweredAsByExact) {
  for (const int count : {2, 3, 5, 9}) {
    const Polygon polygon = sieve(count);
    const filtered::PreparedPolygon prepared(polygon);
    const exact::PreparedPolygon truth(polygon);
    for (double y = -1; y <= 4 * count + 1; ++y)
      for (double x = -1; x <= 4 * count + 1; x += 1.5)
        for (const double radius : {0.0, 0.75}) {
          const Ball ball{{x, y, x / 2}, radius};
          EXPECT_EQ(filtered::answer(ball, prepared), exact::answer(ball, truth))
              << count << " holes a row, centre " << x << ", " << y << ", radius " << radius;
          EXPECT_EQ(filtered::contact(ball, prepared), exact::contact(ball, truth))
              << count << " holes a row, centre " << x << ", " << y << ", radius " << radius;
        }
  }
}

// A ball about a vertex overlaps however small it is, and touches where it is a point.
TEST(FilteredManyHoles, OverlapBallsOfAnySizeAboutTheirVertices) {
  const Polygon polygon = sieve(2);
  const filtered::PreparedPolygon prepared(polygon);
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    for (const double radius : {0.0, 0x1p-1000, 0x1p-500, 0x1p-300, 0x1p-60}) {
      const Ball ball{polygon.vertex(i), radius};
      EXPECT_EQ(filtered::answer(ball, prepared), exact::answer(ball, polygon)) << "vertex " << i << ", " << radius;
      EXPECT_EQ(filtered::relation(ball, prepared), radius > 0 ? Relation::Overlapping : Relation::Touching)
          << "vertex " << i << ", " << radius;
    }
}

}  // namespace
}  // namespace touchstone::filtered_tests

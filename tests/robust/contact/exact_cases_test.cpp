// SPDX-License-Identifier: GPL-3.0-or-later
// Exact answers derived by hand: every key, ties, touching, lifts in fractions, the ends of the range of doubles.
#include <gtest/gtest.h>

#include <cmath>

#include "robust/exact/detail/edge_sweep.h"
#include "robust/exact/exact.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/limits.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/rejection_code.h"

namespace touchstone::contact_tests {
namespace {

using Kind = Feature::Kind;

void expect_exact(const HandCase& c) {
  EXPECT_EQ(exact::answer(c.given.ball, c.given.polygon), c.expected) << c.given.id;
}

TEST(ExactCases, EveryKeyIsThatDerivedByHandInEachCoordinatePlane) {
  for (const HandCase& c : hand_cases())
    for (int times = 0; times < 3; ++times) expect_exact(turned(c, times));
}

// As multiples of the least double (every number subnormal), and where the next power of two would overflow.
TEST(ExactCases, EveryKeyIsThatDerivedByHandAtBothEndsOfTheDoubles) {
  for (const HandCase& c : hand_cases())
    for (const int exponent : {-1074, -1023, 1020})
      expect_exact({scaled(c.given, exponent), scaled(c.expected, exponent)});
}

// Identity (11) of exact.h, with normals that are exact.
TEST(ExactCases, ACentreThatMovesAlongTheNormalOfAFaceKeepsPointAndNormal) {
  int faces = 0;
  for (const HandCase& c : hand_cases()) {
    if (c.expected.nearest.kind != Kind::Face) continue;
    const Ball farther{c.given.ball.center + c.expected.contact_normal, c.given.ball.radius};
    const Answer answer = exact::answer(farther, c.given.polygon);
    EXPECT_EQ(answer.point, c.expected.point) << c.given.id;
    EXPECT_EQ(answer.contact_normal, c.expected.contact_normal) << c.given.id;
    EXPECT_EQ(answer.depth, c.expected.depth - 1) << c.given.id;
    ++faces;
  }
  EXPECT_GT(faces, 5);
}

/// Vertices 1/3 off the plane through their mean: N = (1, -1, 3), plane z = 1/3 - x/3 + y/3.
const Polygon kThirds({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 1, 1}});

// Lifted to (0, 0, 1/3), (2, 0, -1/3), (1, 1, 1/3), (0, 1, 2/3): thirds are not doubles, yet edge 0 passes through
// (1, 0, 0).
TEST(ExactLift, HoldsFractionsThatNoDoubleHolds) {
  const Eigen::Vector3d normal(0x1.34bf63d156826p-2, -0x1.34bf63d156826p-2,
                               0x1.cf1f15ba01c39p-1);  // (1, -1, 3) / sqrt 11
  const Answer on_edge = exact::answer({{1, 0, 0}, 0}, kThirds);
  EXPECT_EQ(on_edge, (Answer{PlaneSide::Intersects,
                             true,
                             PointLocation::Boundary,
                             {0},
                             Relation::Touching,
                             {Kind::Edge, 0},
                             {1, 0, 0},
                             0,
                             1.0 / 3,
                             normal,
                             0}));
  const Answer above = exact::answer({{2, -1, 3}, 3}, kThirds);  // (1, 0, 0) + N, at distance sqrt(11)
  EXPECT_EQ(above, (Answer{PlaneSide::InFront,
                           false,
                           PointLocation::Boundary,
                           {},
                           Relation::Separate,
                           {Kind::Edge, 0},
                           {1, 0, 0},
                           std::sqrt(11.0),
                           1.0 / 3,
                           normal,
                           -0x1.443949feb79a1p-2}));  // 3 - sqrt 11
  const Answer beyond = exact::answer({{5, 0, -1.0 / 3}, 3}, kThirds);
  EXPECT_EQ(beyond.nearest, (Feature{Kind::Vertex, 1}));
  EXPECT_EQ(beyond.point, Eigen::Vector3d(2, 0, -1.0 / 3));
  EXPECT_EQ(beyond.distance, 3);
  EXPECT_EQ(beyond.relation, Relation::Separate);  // the double nearest to -1/3 is not -1/3
}

TEST(ExactLift, IsThatDerivedByHand) {
  for (const HandCase& c : lifted_cases()) expect_exact(c);
}

// Along x, not along z.
TEST(ExactLift, DropsTheLowestAxisOnATie) {
  EXPECT_EQ(exact::detail::dropped_axis(Polygon({{1, 0, 0}, {3, 0, -4}, {5, 4, -4}, {-1, 4, 0}})), 0);
}

TEST(ExactLift, DropsTheAxisOfTheLargestComponentWhateverItsSign) {
  for (int times = 0; times < 3; ++times) {
    const auto axis = [&](const Loop& loop) {
      return exact::detail::dropped_axis(turned({{"", {{0, 0, 0}, 0}, Polygon(loop)}, {}}, times).given.polygon);
    };
    EXPECT_EQ(axis({{0, 0, 0}, {4, 0, 1}, {0, 4, 1}}), (2 + times) % 3);
    EXPECT_EQ(axis({{0, 0, 0}, {0, 4, 1}, {4, 0, 1}}), (2 + times) % 3);
  }
}

TEST(ExactLift, IsRefusedWithoutANormal) {
  const Polygon line({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  EXPECT_EQ(exact::detail::dropped_axis(line), std::nullopt);
  EXPECT_EQ(rejection_code([&] { const exact::PreparedPolygon prepared(line); }), "zero-normal");
}

// Lengths 600 orders of magnitude apart: 1e-300 above the middle of a triangle of 1e300.
TEST(ExactExtremes, SeesATinyBallOnAHugeTriangle) {
  const Polygon huge({{-1e300, -1e300, 0}, {1e300, -1e300, 0}, {0, 1e300, 0}});
  const Eigen::Vector3d center(0, 0, 1e-300);
  const Answer answer = exact::answer({center, 1e-300}, huge);
  EXPECT_EQ(answer, (Answer{PlaneSide::Intersects,
                            true,
                            PointLocation::Inside,
                            {},
                            Relation::Touching,
                            {Kind::Face, 0},
                            {0, 0, 0},
                            1e-300,
                            0,
                            {0, 0, 1},
                            0}));
  EXPECT_EQ(exact::relation({center, std::nextafter(1e-300, 0)}, huge), Relation::Separate);
  EXPECT_EQ(exact::relation({center, std::nextafter(1e-300, 1)}, huge), Relation::Overlapping);
}

TEST(ExactExtremes, SeesATinyTriangleUnderAHugeBall) {
  const Polygon tiny({{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}});
  const Answer answer = exact::answer({{-1e300, 0, 0}, 1e300}, tiny);
  EXPECT_EQ(answer, (Answer{PlaneSide::Intersects,
                            false,
                            PointLocation::Outside,
                            {0, 2},
                            Relation::Touching,
                            {Kind::Vertex, 0},
                            {0, 0, 0},
                            1e300,
                            0,
                            {-1, 0, 0},
                            0}));
}

// From the corner (-max, -max, -max) to a triangle at (max, max, max): 2 sqrt(3) max is beyond the doubles.
TEST(ExactExtremes, RoundsADistanceBeyondTheDoublesToInfinity) {
  const double less = std::nextafter(kMax, 0);
  const Polygon corner({{kMax, kMax, kMax}, {kMax, less, kMax}, {less, kMax, kMax}});
  const Answer answer = exact::answer({{-kMax, -kMax, -kMax}, kMax}, corner);
  EXPECT_EQ(answer.distance, kInfinity);
  EXPECT_EQ(answer.relation, Relation::Separate);
  EXPECT_EQ(answer.plane, PlaneSide::InFront);  // clockwise from above
  EXPECT_EQ(answer.foot, PointLocation::Outside);
  EXPECT_EQ(answer.nearest.kind, Kind::Edge);  // edge 1, between the two lesser corners
  EXPECT_TRUE(answer.point.allFinite());
}

// Distances of least / sqrt(2) and least / sqrt(10).
TEST(ExactExtremes, RoundsATinyDistanceToZeroThoughItIsPositive) {
  const Polygon triangle({{0, 0, 0}, {kLeast, kLeast, 0}, {0, 8 * kLeast, 0}});
  const Answer answer = exact::answer({{kLeast, 0, 0}, 0}, triangle);
  EXPECT_EQ(answer.distance, kLeast);
  EXPECT_EQ(answer.relation, Relation::Separate);
  const Polygon steep({{0, 0, 0}, {kLeast, 3 * kLeast, 0}, {-kLeast, 8 * kLeast, 0}});
  const Answer small = exact::answer({{kLeast, 2 * kLeast, 0}, 0}, steep);
  EXPECT_EQ(small.distance, 0);
  EXPECT_EQ(small.relation, Relation::Separate);
  EXPECT_EQ(small.foot, PointLocation::Outside);
}

// 2^53 + 1 needs a bit more than a double: computing c - p would lose it.
TEST(ExactExtremes, LosesNoBitOfADifference) {
  const Polygon far({{-0x1p53, 0, 0}, {-0x1p53, 4, 0}, {-0x1p53 - 8, 0, 0}});
  const Answer answer = exact::answer({{1, 1, 0}, 0x1p53}, far);
  EXPECT_EQ(answer.relation, Relation::Separate);  // the distance is 2^53 + 1
  EXPECT_EQ(answer.distance, 0x1p53);              // ties to even
  EXPECT_EQ(exact::relation({{1, 1, 0}, 0x1p53 + 2}, far), Relation::Overlapping);
}

}  // namespace
}  // namespace touchstone::contact_tests

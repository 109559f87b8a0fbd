// SPDX-License-Identifier: GPL-3.0-or-later
// Fast answers derived by hand: on small integers `fast` owes every bit.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"
#include "tests/robust/support/hand_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::contact_tests {
namespace {

using Kind = Feature::Kind;

/// Normals and depths are rounded several times.
void take_normal(Answer& answer, const HandCase& c, double error) {
  EXPECT_NEAR(answer.depth, c.expected.depth, error * (1 + c.expected.distance)) << c.given.id;
  answer.depth = c.expected.depth;
  EXPECT_LE((answer.contact_normal - c.expected.contact_normal).norm(), error) << c.given.id;
  answer.contact_normal = c.expected.contact_normal;
}

void expect_fast(const HandCase& c) {
  const Ball& ball = c.given.ball;
  const fast::PreparedPolygon<> polygon(c.given.polygon);
  Answer answer = fast::answer(ball, polygon);
  take_normal(answer, c, 0x1p-52);
  EXPECT_EQ(answer, c.expected) << c.given.id;
  EXPECT_EQ(fast::contact(ball, polygon), c.expected.contact()) << c.given.id;
  EXPECT_EQ(fast::relation(ball, polygon), c.expected.relation) << c.given.id;
  EXPECT_EQ(fast::plane_side(ball, polygon), c.expected.plane) << c.given.id;
  EXPECT_EQ(fast::foot(ball, polygon), c.expected.foot) << c.given.id;
  EXPECT_EQ(fast::edges_hit(ball, polygon), c.expected.edges_hit) << c.given.id;
}

TEST(FastCases, EveryKeyIsThatDerivedByHandInEachCoordinatePlane) {
  for (const HandCase& c : hand_cases())
    for (int times = 0; times < 3; ++times) expect_fast(turned(c, times));
}

TEST(FastCases, EveryKeyIsThatDerivedByHandAtSafeSizes) {
  for (const HandCase& c : hand_cases())
    for (const int exponent : {-160, 160}) expect_fast({scaled(c.given, exponent), scaled(c.expected, exponent)});
}

/// Distances that are not floats are rounded to one.
template <class Scalar>
void expect_in() {
  for (const HandCase& c : hand_cases()) {
    const fast::PreparedPolygon<Scalar> polygon(c.given.polygon);
    Answer answer = fast::answer(c.given.ball, polygon);
    EXPECT_NEAR(answer.distance, c.expected.distance, 1e-6) << c.given.id;
    answer.distance = c.expected.distance;
    take_normal(answer, c, 1e-6);
    EXPECT_EQ(answer, c.expected) << c.given.id;
  }
}

TEST(FastCases, EveryDecisionIsThatDerivedByHandInFloat) { expect_in<float>(); }
TEST(FastCases, EveryDecisionIsThatDerivedByHandInLongDouble) { expect_in<long double>(); }

// The foot (0, 0, 0) is 2 from every edge, and both ends of one that is nearly parallel to the ray are 2^-53 from it:
// rounded, they lie on either side, while its own direction says that it passes on the other side.
TEST(FastFoot, IsNotMisjudgedFarFromTheBoundary) {
  const auto on_slope = [](double x, double y) { return Eigen::Vector3d(x, y, y / 2); };
  const double low = 0x1p-53, high = low + 0x1p-105;
  const Polygon polygon(
      {on_slope(-6, -6), on_slope(6, -6), on_slope(6, high), on_slope(2, low), on_slope(2, 6), on_slope(-6, 6)});
  for (const double side : {-1.0, 1.0}) {
    const Ball ball{{0, -side, 2 * side}, 2.5};
    EXPECT_EQ(exact::foot(ball, polygon), PointLocation::Inside);
    EXPECT_EQ(fast::foot(ball, polygon), PointLocation::Inside);
    EXPECT_TRUE(fast::contact(ball, polygon));
  }
}

// N = (16, -16, 32), plane z = 1 - x/2 + y/2: lifted to heights 1, -1, 1, 3.
TEST(FastLift, MovesEveryVertexOntoThePlane) {
  const fast::PreparedPolygon<> polygon(Polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 4}}));
  EXPECT_EQ(polygon.dropped_axis(), 2);
  EXPECT_EQ(polygon.off_plane(), 1);
  const double heights[] = {1, -1, 1, 3};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(polygon.edges()[i].start.z(), heights[i]);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(polygon.edges()[i].direction.z(), heights[(i + 1) % 4] - heights[i]);

  const Answer answer = fast::answer({{3, 1, 3}, 3}, polygon);  // (2, 2, 1) + N / 16
  EXPECT_EQ(answer.plane, PlaneSide::Intersects);
  EXPECT_EQ(answer.nearest, (Feature{Kind::Face, 0}));
  EXPECT_EQ(answer.point, Eigen::Vector3d(2, 2, 1));
  EXPECT_DOUBLE_EQ(answer.distance, std::sqrt(6.0));
}

// N = (-1/2, -1/2, 2) and the mean height is 1/8: vertex 2 sinks from 1/2 to 3/8.
TEST(FastLift, MovesVerticesAsExactDoes) {
  const Polygon quad({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}});
  for (const Answer& answer : {fast::answer({{3, 3, 0}, 1}, quad), exact::answer({{3, 3, 0}, 1}, quad)}) {
    EXPECT_EQ(answer.point, Eigen::Vector3d(1, 1, 0.375));
    EXPECT_EQ(answer.off_plane, 0.125);
  }
}

TEST(FastLift, IsThatDerivedByHand) {
  for (const HandCase& c : lifted_cases()) expect_fast(c);
}

}  // namespace
}  // namespace touchstone::contact_tests

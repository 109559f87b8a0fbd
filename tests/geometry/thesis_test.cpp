// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's method on inputs small enough to follow by hand: each test, each option, each known error.
#include "geometry/contact/thesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"

namespace touchstone::geometry_tests {
namespace {

using namespace thesis;
using Edges = std::vector<std::size_t>;

const Polygon kSquare({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
const Polygon kU({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
/// A square of side 8 with a square hole of side 2 in its middle.
const Polygon kFrame({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{{3, 3, 0}, {5, 3, 0}, {5, 5, 0}, {3, 5, 0}}});
/// The first three vertices lie on a line.
const Polygon kCollinearStart({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});

PointLocation foot_of(double x, double y, const Polygon& polygon, const Options& options = {}) {
  return foot(Ball{{x, y, 0}, 1}, PreparedPolygon<>(polygon, options));
}

bool contact_of(const Ball& ball, const Polygon& polygon, const Options& options = {}) {
  return contact(ball, PreparedPolygon<>(polygon, options));
}

// Counter-clockwise seen from above, so above is the contract's front; (P2-P0)x(P1-P0) points down.
TEST(ThesisPlaneSide, FirstThreeVerticesSwapFrontAndBack) {
  const Ball above{{0.5, 0.5, 2}, 1}, below{{0.5, 0.5, -2}, 1}, across{{0.5, 0.5, 0.5}, 1};
  const PreparedPolygon<> first(kSquare), newell(kSquare, {.normal = Normal::Newell});
  EXPECT_EQ(plane_side(above, first), PlaneSide::Behind);
  EXPECT_EQ(plane_side(below, first), PlaneSide::InFront);
  EXPECT_EQ(plane_side(across, first), PlaneSide::Intersects);
  EXPECT_EQ(plane_side(above, newell), PlaneSide::InFront);
  EXPECT_EQ(plane_side(below, newell), PlaneSide::Behind);
  EXPECT_EQ(plane_side(across, newell), PlaneSide::Intersects);
}

TEST(ThesisNormal, HasLengthOne) {
  const Polygon tilted({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const Eigen::Vector3d expected = Eigen::Vector3d::Constant(-1 / std::numbers::sqrt3);
  EXPECT_TRUE(PreparedPolygon<>(tilted).normal().isApprox(expected));
  EXPECT_TRUE(PreparedPolygon<>(tilted, {.normal = Normal::Newell}).normal().isApprox(-expected));
}

// Zero normal, NaN, every comparison false: the ball sits in the middle of the polygon and nothing is said.
TEST(ThesisNormal, CollinearFirstThreeVerticesMissSilently) {
  const Ball ball{{1, 1, 0}, 0.5}, on_edge{{1, 0, 0}, 0.5};
  const PreparedPolygon<> first(kCollinearStart);
  EXPECT_TRUE(first.normal().array().isNaN().all());
  EXPECT_EQ(plane_side(ball, first), PlaneSide::Behind);
  EXPECT_EQ(foot(ball, first), PointLocation::Outside);
  EXPECT_FALSE(contact(ball, first));
  EXPECT_EQ(edges_hit(on_edge, first), (Edges{0, 1}));
  EXPECT_FALSE(contact(on_edge, first));

  EXPECT_TRUE(contact_of(ball, kCollinearStart, {.normal = Normal::Newell}));
  EXPECT_TRUE(contact_of(on_edge, kCollinearStart, {.normal = Normal::Newell}));
}

TEST(ThesisComparison, TouchingCountsOnlyWhenClosed) {
  const Options closed{.comparison = Comparison::Closed};
  const Ball face{{0.5, 0.5, 1}, 1}, edge{{2, 0.5, 0}, 1}, vertex{{4, 5, 0}, 5}, point{{0.5, 0.5, 0}, 0};
  for (const Ball& touching : {face, edge, vertex, point}) {
    EXPECT_FALSE(contact_of(touching, kSquare)) << touching.center.transpose();
    EXPECT_TRUE(contact_of(touching, kSquare, closed)) << touching.center.transpose();
  }
  EXPECT_EQ(plane_side(face, PreparedPolygon<>(kSquare)), PlaneSide::Behind);
  EXPECT_EQ(plane_side(face, PreparedPolygon<>(kSquare, closed)), PlaneSide::Intersects);
  EXPECT_EQ(edges_hit(edge, PreparedPolygon<>(kSquare)), Edges{});
  EXPECT_EQ(edges_hit(edge, PreparedPolygon<>(kSquare, closed)), Edges{1});
}

// Vertex (1, 1) of the square is at distance 5 from (4, 5): both its edges are touched there.
TEST(ThesisEdgesHit, ClampsToTheEnds) {
  const PreparedPolygon<> square(kSquare);
  EXPECT_EQ(edges_hit({{4, 5, 0}, 4.9}, square), Edges{});
  EXPECT_EQ(edges_hit({{4, 5, 0}, 5.1}, square), (Edges{1, 2}));
  EXPECT_EQ(edges_hit({{0.5, 0.25, 0.25}, 0.5}, square), Edges{0});
  EXPECT_EQ(edges_hit({{0.5, 0.5, 0}, 0.5}, square), Edges{});
}

// In float 1 + 2^-30 is 1: the edge has no direction and its distance is NaN.
TEST(ThesisEdgesHit, AnEdgeThatVanishesInFloatIsNeverHit) {
  const Polygon polygon({{0, 0, 0}, {1, 0, 0}, {1 + 0x1p-30, 0, 0}, {1, 1, 0}});
  const Ball ball{{1, 0, 0}, 0.5};
  EXPECT_EQ(edges_hit(ball, PreparedPolygon<double>(polygon)), (Edges{0, 1, 2}));
  EXPECT_EQ(edges_hit(ball, PreparedPolygon<float>(polygon)), (Edges{0, 2}));
}

TEST(ThesisFoot, TellsInsideFromOutside) {
  EXPECT_EQ(foot_of(0.5, 0.5, kSquare), PointLocation::Inside);
  EXPECT_EQ(foot_of(1.5, 0.5, kSquare), PointLocation::Outside);
  EXPECT_EQ(foot_of(-3, 7, kSquare), PointLocation::Outside);
}

// Two angles are 0/0, so 0; the other two add up to 90 degrees. The edges make up for it.
TEST(ThesisFoot, AVertexIsOutside) {
  EXPECT_EQ(foot_of(1, 1, kSquare), PointLocation::Outside);
  EXPECT_TRUE(contact_of({{1, 1, 0}, 0.01}, kSquare));
}

// In the notch's corner of the U the same two angles are 0, yet the others add up to more than 2 pi.
TEST(ThesisFoot, ANotchMakesUpForAnglesThatAreNaN) {
  EXPECT_EQ(foot_of(1, 1, kU), PointLocation::Inside);
  EXPECT_EQ(foot_of(1, 1, kU, {.angles = Angles::Signed}), PointLocation::Outside);
}

// The gripper: between the jaws the unsigned angles add up to 2 pi at the mouth and to more within.
TEST(ThesisAngles, UnsignedFillsTheNotchOfAU) {
  for (int i = 1; i < 16; ++i)
    for (int j = 1; j < 32; ++j) {
      const double x = 1 + i / 16., y = 1 + j / 16.;
      EXPECT_EQ(foot_of(x, y, kU, {.angles = Angles::Unsigned}), PointLocation::Inside) << x << ", " << y;
      EXPECT_EQ(foot_of(x, y, kU, {.angles = Angles::Signed}), PointLocation::Outside) << x << ", " << y;
    }
}

TEST(ThesisAngles, SignedKnowsEitherOrientation) {
  const Polygon reversed({{0, 3, 0}, {1, 3, 0}, {1, 1, 0}, {2, 1, 0}, {2, 3, 0}, {3, 3, 0}, {3, 0, 0}, {0, 0, 0}});
  for (const Polygon& u : {kU, reversed})
    for (const Normal normal : {Normal::FirstThreeVertices, Normal::Newell}) {
      const Options options{.angles = Angles::Signed, .normal = normal};
      EXPECT_EQ(foot_of(0.5, 2, u, options), PointLocation::Inside);
      EXPECT_EQ(foot_of(1.5, 2, u, options), PointLocation::Outside);
      EXPECT_EQ(foot_of(4, 2, u, options), PointLocation::Outside);
    }
}

// From delta outside the middle of an edge of length L of a convex polygon, the edge is seen at 2 atan(L / (2 delta))
// and the others together at the same angle: 0.99 x 2 pi is reached at delta = L / (2 tan 89.1 deg) = 0.00785 L.
TEST(ThesisMatchFactor, TakesInABandOutsideEachEdge) {
  const double band = 1 / (2 * std::tan(0.99 * std::numbers::pi / 2));
  EXPECT_NEAR(band, 0.00785, 5e-6);
  for (const double length : {0.125, 1., 100.}) {
    const Polygon square({{0, 0, 0}, {length, 0, 0}, {length, length, 0}, {0, length, 0}});
    const Polygon triangle({{0, 0, 0}, {length, 0, 0}, {0, length, 0}});
    for (const Polygon& polygon : {square, triangle}) {
      EXPECT_EQ(foot_of(length / 2, -0.00780 * length, polygon), PointLocation::Inside);
      EXPECT_EQ(foot_of(length / 2, -0.00790 * length, polygon), PointLocation::Outside);
      EXPECT_EQ(foot_of(length / 2, -band * (1 - 1e-9) * length, polygon), PointLocation::Inside);
      EXPECT_EQ(foot_of(length / 2, -band * (1 + 1e-9) * length, polygon), PointLocation::Outside);
      EXPECT_EQ(foot_of(length / 2, -0.00780 * length, polygon, {.match_factor = 0.9999}), PointLocation::Outside);
    }
  }
}

// The factor is there for a reason: with 1, rounding loses points well inside.
TEST(ThesisMatchFactor, OneLosesPointsInside) {
  int lost = 0;
  for (int i = 1; i < 64; ++i)
    for (int j = 1; j < 64; ++j) {
      EXPECT_EQ(foot_of(i / 64., j / 64., kSquare, {.match_factor = 0.9999}), PointLocation::Inside);
      lost += foot_of(i / 64., j / 64., kSquare, {.match_factor = 1}) == PointLocation::Outside;
    }
  EXPECT_GT(lost, 0);  // 155 of 3969 with glibc 2.36
}

// A cull by the bounding box changes this method's answers: the box does not know the band outside the edges.
TEST(ThesisMatchFactor, ABoundingBoxRemovesFalseHits) {
  const Ball beside{{0.5, -0.005, 0}, 0.002};
  ASSERT_LT(beside.center.y() + beside.radius, 0);
  EXPECT_TRUE(contact_of(beside, kSquare));
}

// The foot lies on the edge from (0, 0) to (3, 1), and u.v / |u||v| rounds below -1.
TEST(ThesisArc, CosineLosesAnAngleOnAnEdge) {
  const Polygon triangle({{0, 0, 0}, {3, 1, 0}, {1, 3, 0}});
  const double t = 15 / 64.;
  EXPECT_EQ(foot_of(3 * t, t, triangle, {.arc = Arc::Cosine}), PointLocation::Outside);
  EXPECT_EQ(foot_of(3 * t, t, triangle, {.arc = Arc::Tangent}), PointLocation::Inside);
}

// Points rounded to float on an edge of a random triangle of size 1000: where acos is NaN, and only there, the cosine
// says outside. FACTS: "about a quarter"; the share depends on how edges are drawn. Seen here: 22.5 % of 200,000.
TEST(ThesisArc, CosineIsNaNForAboutAQuarterOfPointsOnAnEdgeInFloat) {
  constexpr std::uint64_t seed = 2008, samples = 200 * TOUCHSTONE_SAMPLES;
  std::uint64_t lost = 0;
  for (std::uint64_t i = 0; i < samples; ++i) {
    workloads::Random random(seed, i);
    const auto coordinate = [&] { return static_cast<double>(static_cast<float>(2000 * random.unit() - 1000)); };
    const auto vertex = [&] {
      const double x = coordinate();
      return Eigen::Vector3d(x, coordinate(), 0);
    };
    const Eigen::Vector3d a = vertex(), b = vertex(), c = vertex();
    const Ball ball{a + random.unit() * (b - a), 1};
    const Polygon triangle({a, b, c});
    lost += foot(ball, PreparedPolygon<float>(triangle)) == PointLocation::Outside;
    EXPECT_EQ(foot(ball, PreparedPolygon<float>(triangle, {.arc = Arc::Tangent})), PointLocation::Inside);
  }
  const double share = static_cast<double>(lost) / static_cast<double>(samples);
  RecordProperty("share_of_nan", std::to_string(share));
  EXPECT_NEAR(share, 0.225, 4 * std::sqrt(0.225 * 0.775 / static_cast<double>(samples)));
}

// Chosen for holes: inside the outer loop and inside no hole; the edges of holes count.
TEST(ThesisHoles, AreLeftOut) {
  EXPECT_EQ(foot_of(1.5, 1.5, kFrame), PointLocation::Inside);
  EXPECT_EQ(foot_of(4, 4, kFrame), PointLocation::Outside);
  EXPECT_EQ(foot_of(9, 4, kFrame), PointLocation::Outside);
  EXPECT_FALSE(contact_of({{4, 4, 0}, 0.9}, kFrame));
  EXPECT_TRUE(contact_of({{4, 4, 0}, 1.1}, kFrame));
  EXPECT_EQ(edges_hit({{4, 3.5, 0}, 0.75}, PreparedPolygon<>(kFrame)), Edges{4});
}

TEST(ThesisHoles, LeaveTheNormalAlone) {
  const Polygon bent({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}, {{{3, 3, 0}, {5, 3, 2}, {5, 5, 2}, {3, 5, 0}}});
  EXPECT_EQ(PreparedPolygon<>(bent, {.normal = Normal::Newell}).normal(), Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(PreparedPolygon<>(bent).normal(), Eigen::Vector3d(0, 0, -1));
}

// The band that the factor takes in outside the hole is taken from the polygon: small balls there are missed.
TEST(ThesisHoles, TheMatchFactorGivesAwayTheirRim) {
  const Ball ball{{4, 2.99, 0}, 0.001};
  EXPECT_FALSE(contact_of(ball, kFrame));
  EXPECT_TRUE(contact_of(ball, kFrame, {.match_factor = 0.9999}));
}

// 2^22 away from the origin the floats are 1/2 apart: every coordinate below is one, and s is off by more than r.
TEST(ThesisFloat, LosesThePlaneFarFromTheOrigin) {
  for (const double o : {0., 0x1p22}) {
    const Polygon tilted({{o + 12, o, o}, {o, o + 12, o}, {o, o, o + 12}});
    const Ball on_plane{{o + 1, o + 1, o + 10}, 0.5};
    EXPECT_EQ(contact(on_plane, PreparedPolygon<float>(tilted)), o == 0) << o;
    EXPECT_TRUE(contact(on_plane, PreparedPolygon<double>(tilted))) << o;
  }
}

}  // namespace
}  // namespace touchstone::geometry_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate triangles, as which segments and points are taken: against rationals, in every engine and every state.
#include "tests/robust/support/degenerate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <vector>

#include "geometry/shapes/segment.h"
#include "robust/exact/exact.h"
#include "robust/filtered/triangle_set.h"
#include "tests/robust/support/all_kernels.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/rejection_code.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using Eigen::Vector3d;
using filtered::TriangleSet;

/// The sign of a root of `squared` less a number.
int compare_root(const mpq_class& squared, const mpq_class& number) {
  return number < 0 ? 1 : cmp(squared, mpq_class(number * number));
}

Relation relation_of(const DegenerateTruth& truth, double radius) {
  const int sign = compare_root(truth.squared_distance, mpq_class(radius));
  return sign > 0 ? Relation::Separate : sign < 0 ? Relation::Overlapping : Relation::Touching;
}

/// Holds the members of an answer against rationals.
void expect_rounded(const DegenerateTruth& truth, const Feature& feature, const Vector3d& point, double distance,
                    const Vector3d& normal) {
  RC_ASSERT(feature == truth.nearest);
  RC_ASSERT(is_nearest(distance, [&](const mpq_class& m) { return compare_root(truth.squared_distance, m); }));
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class &at = truth.point[static_cast<std::size_t>(axis)],
                    &away = truth.away[static_cast<std::size_t>(axis)];
    RC_ASSERT(is_nearest(point[axis], [&](const mpq_class& m) { return cmp(at, m); }));
    if (truth.squared_distance == 0) {
      RC_ASSERT(normal[axis] == 0);
      continue;
    }
    const mpq_class share = away * away / truth.squared_distance;
    RC_ASSERT(is_nearest(normal[axis], [&](const mpq_class& m) {
      return sgn(away) >= 0 ? compare_root(share, m) : -compare_root(share, mpq_class(-m));
    }));
  }
}

RC_GTEST_PROP(Degenerate, ExactAnswersAreThoseOfRationals, ()) {
  const DegenerateCase c = *degenerate_cases();
  const Ball& ball = c.motion.ball;
  const DegenerateTruth truth(c.triangle, rationals(ball.center));
  const Answer answer = exact::answer(ball, exact::PreparedPolygon(c.triangle));
  expect_rounded(truth, answer.nearest, answer.point, answer.distance, answer.contact_normal);
  RC_ASSERT(answer.relation == relation_of(truth, ball.radius));
  RC_ASSERT(is_nearest(answer.depth, [&](const mpq_class& m) {
    return -compare_root(truth.squared_distance, mpq_class(mpq_class(ball.radius) - m));
  }));
  RC_ASSERT(answer.foot == PointLocation::Outside);
  RC_ASSERT(answer.plane == PlaneSide::Intersects);
  RC_ASSERT(answer.contact() == !answer.edges_hit.empty());
  RC_ASSERT(exact::contact(ball, c.triangle) == answer.contact());
  RC_ASSERT(exact::relation(ball, c.triangle) == answer.relation);
  RC_ASSERT(exact::closest(ball.center, c.triangle) ==
            (ClosestPoint{answer.nearest, answer.point, answer.distance, answer.contact_normal}));
}

RC_GTEST_PROP(Degenerate, FilteredAnswersAreThoseOfExactInEveryEngine, ()) {
  const DegenerateCase c = *degenerate_cases();
  const Ball& ball = c.motion.ball;
  const Answer truth = exact::answer(ball, exact::PreparedPolygon(c.triangle));
  const ClosestPoint closest{truth.nearest, truth.point, truth.distance, truth.contact_normal};
  RC_ASSERT(filtered::contact(ball, c.triangle) == truth.contact());
  RC_ASSERT(filtered::relation(ball, c.triangle) == truth.relation);
  RC_ASSERT(filtered::closest(ball.center, c.triangle) == closest);
  for (const auto* kernels : all_kernels()) {
    filtered::NoCounts none;
    filtered::StageCounts counts;
    const auto view = filtered::detail::view_of(ball, c.triangle);
    RC_ASSERT(kernels->plain.triangle_contact(view, none) == truth.contact());
    RC_ASSERT(kernels->counted.triangle_contact(view, counts) == truth.contact());
    RC_ASSERT(counts != filtered::StageCounts{});
    ClosestPoint found{};
    double depth = 0;
    kernels->plain.triangle_closest(view, found, &depth, none);
    RC_ASSERT(found == closest);
    RC_ASSERT(same_number(depth, truth.depth));
  }
}

RC_GTEST_PROP(Degenerate, AnswersAreTheSameInEveryFloatingPointState, ()) {
  const DegenerateCase c = *degenerate_cases();
  const Ball& ball = c.motion.ball;
  const Answer truth = exact::answer(ball, exact::PreparedPolygon(c.triangle));
  for (const State& state : kStates) {
    Relation relation{};
    bool touches = false, left_as_found = false;
    ClosestPoint closest{};
    {
      const Environment changed(state);
      touches = filtered::contact(ball, c.triangle);
      relation = filtered::relation(ball, c.triangle);
      closest = filtered::closest(ball.center, c.triangle);
      left_as_found = changed.left_as_found();
    }
    RC_ASSERT(touches == truth.contact());
    RC_ASSERT(relation == truth.relation);
    RC_ASSERT(closest == (ClosestPoint{truth.nearest, truth.point, truth.distance, truth.contact_normal}));
    RC_ASSERT(left_as_found);
  }
}

// Triangles that have a face keep their answers; `relation` is new for them.
RC_GTEST_PROP(Degenerate, TheRelationOfATriangleWithAFaceIsThatOfExact, ()) {
  const Case c = *hard_triangles();
  const Triangle triangle = triangle_of(c.polygon);
  const Relation truth = exact::relation(c.ball, c.polygon);
  RC_ASSERT(filtered::relation(c.ball, triangle) == truth);
  RC_ASSERT(exact::relation(c.ball, triangle) == truth);
  RC_ASSERT(exact::answer(c.ball, exact::PreparedPolygon(triangle)) == exact::answer(c.ball, c.polygon));
}

// Of a lattice's triangles, among them those that are degenerate in any way, in groups of eight and single.
RC_GTEST_PROP(Degenerate, SetsTakeSegmentsAndPoints, ()) {
  std::vector<Triangle> triangles;
  for (int i = *rc::gen::inRange(1, 12); i > 0; --i) triangles.push_back((*degenerate_lattice_cases()).triangle);
  const DegenerateCase c = *degenerate_cases();
  triangles.push_back(c.triangle);
  triangles.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const TriangleSet set(triangles, Degenerate::AsSegments);
  for (const Ball& ball : {c.motion.ball, (*degenerate_lattice_cases()).motion.ball}) {
    std::vector<std::size_t> truth;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (exact::contact(ball, triangles[i])) truth.push_back(i);
    RC_ASSERT(triangles_hit(ball, set) == truth);
    RC_ASSERT(any_contact(ball, set) == !truth.empty());
    const std::unique_ptr<bool[]> touches(new bool[triangles.size()]());
    contact(ball, set, {touches.get(), triangles.size()});
    for (std::size_t i = 0; i < triangles.size(); ++i) RC_ASSERT(touches[i] == exact::contact(ball, triangles[i]));
  }
}

TEST(Degenerate, SetsRefuseThemUnlessTold) {
  const std::vector<Triangle> triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}};
  EXPECT_EQ(rejection_code([&] { (void)TriangleSet(triangles); }), "zero-normal");
  EXPECT_EQ(TriangleSet(triangles, Degenerate::AsSegments).size(), 2U);
  const std::vector<Triangle> infinite{Segment{{0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 0}}};
  EXPECT_EQ(rejection_code([&] { (void)TriangleSet(infinite, Degenerate::AsSegments); }), "not-finite");
}

// A segment has vertices 0 and 1 and edge 0; a point has vertex 0.
TEST(Degenerate, ASegmentIsATriangle) {
  const Segment segment{{0, 0, 0}, {4, 0, 0}}, point{{1, 2, 2}, {1, 2, 2}};
  using Kind = Feature::Kind;
  EXPECT_EQ(filtered::closest({1, 0, 3}, segment), (ClosestPoint{{Kind::Edge, 0}, {1, 0, 0}, 3, {0, 0, 1}}));
  EXPECT_EQ(filtered::closest({-3, 4, 0}, segment), (ClosestPoint{{Kind::Vertex, 0}, {0, 0, 0}, 5, {-0.6, 0.8, 0}}));
  EXPECT_EQ(filtered::closest({7, 0, 4}, segment), (ClosestPoint{{Kind::Vertex, 1}, {4, 0, 0}, 5, {0.6, 0, 0.8}}));
  EXPECT_EQ(filtered::closest({2, 0, 0}, segment), (ClosestPoint{{Kind::Edge, 0}, {2, 0, 0}, 0, {0, 0, 0}}));
  EXPECT_EQ(filtered::closest({1, 2, 5}, point), (ClosestPoint{{Kind::Vertex, 0}, {1, 2, 2}, 3, {0, 0, 1}}));
  EXPECT_EQ(filtered::relation({{0, 0, 0}, 3}, point), Relation::Touching);
  EXPECT_EQ(filtered::relation({{0, 0, 0}, std::nextafter(3, 0)}, point), Relation::Separate);
}

// Fibonacci numbers: the corners turn by 1, of which doubles know nothing. The normal lies along one axis alone.
TEST(Degenerate, IsNoTriangleThatHasAnArea) {
  const double f[] = {1304969544928657, 2111485077978050, 3416454622906707, 5527939700884757};
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [axis](double u, double v, double height) {
      Vector3d point;
      point[axis] = height, point[(axis + 1) % 3] = u, point[(axis + 2) % 3] = v;
      return point;
    };
    const Triangle thin{at(0, 0, 0), at(f[2], f[1], 0), at(f[1], f[0], 0)};
    const Vector3d above = at(f[3] / 4, f[2] / 4, 3);
    EXPECT_EQ(filtered::closest(above, thin).feature, (Feature{Feature::Kind::Face, 0})) << axis;
    EXPECT_EQ(filtered::relation({above, 3}, thin), Relation::Touching) << axis;
  }
}

// An edge that holds the point goes before a vertex that is there, and lower numbers go first.
TEST(Degenerate, FeaturesHaveTheNumbersOfTheTriangle) {
  using Kind = Feature::Kind;
  const Triangle middle{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, folded{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(filtered::closest({1, 0, 1}, middle).feature, (Feature{Kind::Edge, 0}));
  EXPECT_EQ(filtered::closest({1, 0, 1}, folded).feature, (Feature{Kind::Edge, 2}));
  EXPECT_EQ(filtered::closest({2, 0, 1}, folded).feature, (Feature{Kind::Edge, 1}));
  EXPECT_EQ(filtered::closest({9, 0, 1}, folded).feature, (Feature{Kind::Vertex, 2}));
  EXPECT_EQ(filtered::closest({9, 0, 1}, Triangle{{0, 0, 0}, {3, 0, 0}, {3, 0, 0}}).feature,
            (Feature{Kind::Vertex, 1}));
}

}  // namespace
}  // namespace touchstone::filtered_tests

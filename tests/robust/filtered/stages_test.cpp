// SPDX-License-Identifier: GPL-3.0-or-later
// Which stage decides: by hand, the answer and the stage of each, for a triangle and for prepared polygons.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered {

void PrintTo(Stage stage, std::ostream* out) { *out << to_string(stage); }

}  // namespace touchstone::filtered

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using filtered::Stage;
using filtered::StageCounts;
using workloads::move_by_doubles;

/// A question of contact, its answer, and the stages that may be the slowest one to decide anything.
struct StagedCase {
  std::string id;
  Ball ball;
  Polygon polygon;
  bool touches;
  Stage first, last;
};

void expect_stage(const StagedCase& c) {
  ASSERT_EQ(exact::contact(c.ball, c.polygon), c.touches) << c.id;
  StageCounts prepared_counts, triangle_counts;
  EXPECT_EQ(filtered::contact(c.ball, filtered::PreparedPolygon(c.polygon), prepared_counts), c.touches) << c.id;
  EXPECT_GE(prepared_counts.last(), c.first) << c.id << ", prepared";
  EXPECT_LE(prepared_counts.last(), c.last) << c.id << ", prepared";
  if (c.polygon.vertex_count() != 3) return;
  EXPECT_EQ(filtered::contact(c.ball, triangle_of(c.polygon), triangle_counts), c.touches) << c.id;
  EXPECT_GE(triangle_counts.last(), c.first) << c.id << ", as a triangle";
  EXPECT_LE(triangle_counts.last(), c.last) << c.id << ", as a triangle";
}

/// The lattice turned: u, v and w are orthogonal, of length 3.
Eigen::Vector3d turned(double x, double y, double h) {
  return x * Eigen::Vector3d(1, 2, 2) + y * Eigen::Vector3d(2, 1, -2) + h * Eigen::Vector3d(2, -2, 1);
}

const Polygon& right_triangle() {
  static const Polygon polygon({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  return polygon;
}

/// All bits of every coordinate in use.
const Polygon& tilted_triangle() {
  static const Polygon polygon({{0.1, 0.2, 0.3}, {1.7, -0.4, 0.9}, {-0.3, 1.9, 0.5}});
  return polygon;
}

/// An L, tilted and exactly planar.
const Polygon& tilted_l() {
  static const Polygon polygon(
      {turned(0, 0, 0), turned(6, 0, 0), turned(6, 2, 0), turned(2, 2, 0), turned(2, 6, 0), turned(0, 6, 0)});
  return polygon;
}

/// The same L, larger, so that the signs' products are not doubles.
const Polygon& large_l() {
  static const Polygon polygon({turned(0, 0, 0), turned(60'000, 0, 0), turned(60'000, 20'000, 0),
                                turned(20'000, 20'000, 0), turned(20'000, 60'000, 0), turned(0, 60'000, 0)});
  return polygon;
}

/// Touched in a tie that takes 200 binary orders to see.
const Polygon& wide_triangle() {
  static const Polygon polygon({{-1, -1, 0}, {2, 0x1p-190, 0}, {0.1, 2, 0}});
  return polygon;
}
const Ball kWideTie{{0.25, 0.25, 0x1p-200}, 0x1p-200};

// Nothing is near any boundary: one pass in doubles, and nothing else is asked.
TEST(Stages, DoublesDecideWhatIsClear) {
  const std::vector<StagedCase> cases{
      {"far away", {{100, 100, 100}, 1}, right_triangle(), false, Stage::Double, Stage::Double},
      {"beside it in its plane", {{9, 9, 0}, 1}, right_triangle(), false, Stage::Double, Stage::Double},
      {"above it", {{1, 1, 3}, 1}, right_triangle(), false, Stage::Double, Stage::Double},
      {"through the face", {{1, 1, 0.5}, 0.75}, right_triangle(), true, Stage::Double, Stage::Double},
      {"over a vertex", {{-0.5, -0.5, 0.25}, 2}, right_triangle(), true, Stage::Double, Stage::Double},
      {"over an edge", {{2, -0.5, 0.25}, 1}, right_triangle(), true, Stage::Double, Stage::Double},
      {"around all of it", {{1, 1, 0.125}, 50}, right_triangle(), true, Stage::Double, Stage::Double},
      {"far from a tilted one", {{-30, 20, 10}, 3}, tilted_triangle(), false, Stage::Double, Stage::Double},
      {"through a tilted face", {{0.5, 0.5, 0.55}, 0.3}, tilted_triangle(), true, Stage::Double, Stage::Double},
      {"far from an L", {turned(40, 40, 40), 1}, tilted_l(), false, Stage::Double, Stage::Double},
      {"through an L", {turned(1, 1, 0.25), 1.5}, tilted_l(), true, Stage::Double, Stage::Double},
      {"in the notch of an L", {turned(5, 5, 0), 1.5}, tilted_l(), false, Stage::Double, Stage::Double},
  };
  for (const StagedCase& c : cases) expect_stage(c);
}

TEST(Stages, DoublesCountOneQuestion) {
  StageCounts counts;
  ASSERT_FALSE(filtered::contact({{100, 100, 100}, 1}, triangle_of(right_triangle()), counts));
  ASSERT_FALSE(filtered::contact({{100, 100, 100}, 1}, filtered::PreparedPolygon(right_triangle()), counts));
  EXPECT_EQ(counts.decided_by(Stage::Double), 2U);
  for (const Stage stage : {Stage::Permanent, Stage::DoubleDouble, Stage::FixedInteger, Stage::BigInteger})
    EXPECT_EQ(counts.decided_by(stage), 0U) << to_string(stage);
}

/// The two doubles on the sides of the distance from this centre, within a double and a half of it: no double that was
/// rounded once can tell them apart, double-doubles have fifty bits to spare.
std::vector<StagedCase> at_threshold(Feature::Kind nearest, const std::string& id, const Eigen::Vector3d& center,
                                     const Polygon& polygon) {
  const Answer answer = exact::answer({center, 0}, polygon);
  EXPECT_EQ(answer.nearest.kind, nearest) << id;
  const Ball below{center, move_by_doubles(answer.distance, -1)}, above{center, move_by_doubles(answer.distance, 1)};
  return {{id + ", below", below, polygon, false, Stage::Permanent, Stage::DoubleDouble},
          {id + ", above", above, polygon, true, Stage::Permanent, Stage::DoubleDouble}};
}

const Eigen::Vector3d kOverTiltedFace(0.4, 0.5, 1.2);

TEST(Stages, DoubleDoublesSeparateNeighbouringRadii) {
  using enum Feature::Kind;
  for (const auto& cases : {at_threshold(Face, "face", kOverTiltedFace, tilted_triangle()),
                            at_threshold(Edge, "edge", {1.1, 1.3, 0.1}, tilted_triangle()),
                            at_threshold(Vertex, "vertex", {2.9, -1.4, 1.3}, tilted_triangle()),
                            at_threshold(Face, "face of an L", turned(1, 3, 0.7), tilted_l()),
                            at_threshold(Edge, "edge of an L", turned(3.3, 3.1, 0.7), tilted_l())})
    for (const StagedCase& c : cases) expect_stage(c);
}

constexpr double kLattice = 0x1p20;

TEST(Stages, FixedIntegersDecideTangencyOnTheLattice) {
  const Polygon large({{0, 0, 0}, {kLattice, 0, 0}, {0, kLattice, 0}});
  const Polygon tilted({turned(0, 0, 0), turned(150'000, 0, 0), turned(7, 200'001, 0)});
  const double k = 12'345;
  const std::vector<StagedCase> cases{
      {"face", {{262'144, 131'072, 524'287}, 524'287}, large, true, Stage::FixedInteger, Stage::FixedInteger},
      {"edge, 3-4-5", {{300'001, -3 * k, 4 * k}, 5 * k}, large, true, Stage::FixedInteger, Stage::FixedInteger},
      {"vertex, 1-2-2-3", {{-k, -2 * k, 2 * k}, 3 * k}, large, true, Stage::FixedInteger, Stage::FixedInteger},
      {"tilted face", {turned(40'000, 30'000, k), 3 * k}, tilted, true, Stage::FixedInteger, Stage::FixedInteger},
      {"tilted edge, 3-4-5",
       {turned(70'000, -3 * k, 4 * k), 15 * k},
       tilted,
       true,
       Stage::FixedInteger,
       Stage::FixedInteger},
      {"tilted vertex", {turned(-k, -2 * k, 2 * k), 9 * k}, tilted, true, Stage::FixedInteger, Stage::FixedInteger},
      {"a point on a vertex", {{kLattice, 0, 0}, 0}, large, true, Stage::FixedInteger, Stage::FixedInteger},
      {"a point on a face", {turned(40'000, 30'000, 0), 0}, tilted, true, Stage::FixedInteger, Stage::FixedInteger},
      {"face of an L", {turned(10'000, 30'000, k), 3 * k}, large_l(), true, Stage::FixedInteger, Stage::FixedInteger},
      {"both edges of the notch of an L",
       {turned(35'000, 35'000, 0), 45'000},
       large_l(),
       true,
       Stage::FixedInteger,
       Stage::FixedInteger},
      {"above the reflex vertex of an L",
       {turned(20'000, 20'000, k), 3 * k},
       large_l(),
       true,
       Stage::FixedInteger,
       Stage::FixedInteger},
  };
  for (const StagedCase& c : cases) expect_stage(c);
}

// Double-doubles round both terms of the sign, and differently: all that they say of a tangent ball is within their
// bound.
TEST(Stages, DoubleDoublesDecideNoTangentBall) {
  for (std::uint64_t i = 0; i < 500 * TOUCHSTONE_SAMPLES; ++i) {
    workloads::Random random(2026, i);
    const auto number = [&random] { return 0.5 + random.unit() / 2; };
    const double height = number(), x = number(), y = number();
    const Polygon polygon({{-3 - number(), 0, 0}, {3 + number(), 0, 0}, {number(), 4 + number(), 0}});
    for (const Ball& ball : {Ball{{x - 0.5, y, height}, height}, Ball{{x - 0.5, -height, 0}, height}}) {
      StageCounts counts;
      EXPECT_TRUE(filtered::contact(ball, triangle_of(polygon), counts)) << "index " << i;
      EXPECT_GE(counts.last(), Stage::FixedInteger) << "index " << i;
    }
  }
}

TEST(Stages, UnlimitedIntegersDecideTheRest) {
  const double least = 0x1p-1074;
  const std::vector<StagedCase> cases{
      {"a tie over 200 binary orders", kWideTie, wide_triangle(), true, Stage::BigInteger, Stage::BigInteger},
      {"a tie of all exponents",
       {{1e300, 1, least}, 1e300},
       Polygon({{0, 1, least}, {-1e300, 1, least}, {-1e-300, 1e-300, least}}),
       true,
       Stage::BigInteger,
       Stage::BigInteger},
      {"least and largest",
       {{0, 0, least}, least},
       Polygon({{-1e300, -1e300, 0}, {1e300, 1, 0}, {1, 1e300, 0}}),
       true,
       Stage::BigInteger,
       Stage::BigInteger},
      {"tiny except one coordinate",
       {{0x1p-1000, 0x1p-1000, 1}, 0},
       Polygon({{0, 0, 1}, {0x1p-998, 0, 1}, {0, 0x1p-998, 1}}),
       true,
       Stage::BigInteger,
       Stage::BigInteger},
  };
  for (const StagedCase& c : cases) expect_stage(c);
}

/// The answer to one question, and the slowest stage that decided any of it.
template <class Result, class Ask>
void expect_decided(const std::string& id, const Result& expected, Stage first, Stage last, const Ask& ask) {
  StageCounts counts;
  EXPECT_EQ(ask(counts), expected) << id;
  EXPECT_GE(counts.last(), first) << id;
  EXPECT_LE(counts.last(), last) << id;
}

/// A question about a ball and a polygon, its answer, and the stages that may be the slowest one to decide any of it.
template <class Result>
struct DecidedCase {
  std::string id;
  Ball ball;
  const Polygon& polygon;
  Result expected;
  Stage first, last;
};

template <class Result, class Question>
void expect_decided(const std::vector<DecidedCase<Result>>& cases, const Question& question) {
  for (const auto& c : cases)
    expect_decided(c.id, c.expected, c.first, c.last,
                   [&](StageCounts& counts) { return question(c.ball, filtered::PreparedPolygon(c.polygon), counts); });
}

TEST(Stages, OfRelations) {
  using enum Relation;
  const double k = 12'345, distance = exact::answer({kOverTiltedFace, 0}, tilted_triangle()).distance;
  const Ball short_of_it{kOverTiltedFace, move_by_doubles(distance, -1)};
  const Ball into_it{kOverTiltedFace, move_by_doubles(distance, 1)};
  const std::vector<DecidedCase<Relation>> cases{
      {"far", {turned(90'000, 90'000, 0), 3 * k}, large_l(), Separate, Stage::Double, Stage::Double},
      {"through", {turned(10'000, 10'000, 5), 3 * k}, large_l(), Overlapping, Stage::Double, Stage::Double},
      {"on", {turned(10'000, 30'000, k), 3 * k}, large_l(), Touching, Stage::FixedInteger, Stage::FixedInteger},
      {"on the reflex vertex",
       {turned(20'000, 20'000, k), 3 * k},
       large_l(),
       Touching,
       Stage::FixedInteger,
       Stage::FixedInteger},
      {"a double short", short_of_it, tilted_triangle(), Separate, Stage::Permanent, Stage::DoubleDouble},
      {"a double into it", into_it, tilted_triangle(), Overlapping, Stage::Permanent, Stage::DoubleDouble},
      {"a tie over 200 orders", kWideTie, wide_triangle(), Touching, Stage::BigInteger, Stage::BigInteger},
  };
  expect_decided(cases, [](const Ball& ball, const filtered::PreparedPolygon& polygon, StageCounts& counts) {
    return filtered::relation(ball, polygon, counts);
  });
}

TEST(Stages, OfThePlane) {
  using enum PlaneSide;
  const double k = 12'345, distance = exact::answer({kOverTiltedFace, 0}, tilted_triangle()).distance;
  const Ball short_of_it{kOverTiltedFace, move_by_doubles(distance, -1)};
  const Ball into_it{kOverTiltedFace, move_by_doubles(distance, 1)};
  const std::vector<DecidedCase<PlaneSide>> cases{
      {"in front", {turned(0, 0, -k), k}, large_l(), InFront, Stage::Double, Stage::Double},
      {"behind", {turned(0, 0, k), k}, large_l(), Behind, Stage::Double, Stage::Double},
      {"through", {turned(0, 0, -k), 4 * k}, large_l(), Intersects, Stage::Double, Stage::Double},
      {"touching", {turned(0, 0, -k), 3 * k}, large_l(), Intersects, Stage::FixedInteger, Stage::FixedInteger},
      {"a double short", short_of_it, tilted_triangle(), InFront, Stage::Permanent, Stage::DoubleDouble},
      {"a double into it", into_it, tilted_triangle(), Intersects, Stage::Permanent, Stage::DoubleDouble},
      {"a tie over 200 orders", kWideTie, wide_triangle(), Intersects, Stage::BigInteger, Stage::BigInteger},
  };
  expect_decided(cases, [](const Ball& ball, const filtered::PreparedPolygon& polygon, StageCounts& counts) {
    return filtered::plane_side(ball, polygon, counts);
  });
}

TEST(Stages, OfTheFoot) {
  using enum PointLocation;
  // The edge rises by three doubles over its length: in its middle it is half a double above 1, where no vertex is.
  const Polygon shallow({{0, 1 - 0x1p-52, 0}, {1, 1 + 0x1p-51, 0}, {0.5, 4, 0}});
  const Polygon wide({{-1, 0, 0}, {1, 0x1p-200, 0}, {0, 2, 0}});
  const std::vector<DecidedCase<PointLocation>> cases{
      {"inside", {turned(10'000, 50'000, 77), 1}, large_l(), Inside, Stage::Double, Stage::Double},
      {"in the notch", {turned(50'000, 50'000, 77), 1}, large_l(), Outside, Stage::Double, Stage::Double},
      {"on an edge", {turned(20'000, 30'000, 77), 1}, large_l(), Boundary, Stage::FixedInteger, Stage::FixedInteger},
      {"on the reflex vertex",
       {turned(20'000, 20'000, 77), 1},
       large_l(),
       Boundary,
       Stage::FixedInteger,
       Stage::FixedInteger},
      {"half a double outside", {{0.5, 1, 0}, 1}, shallow, Outside, Stage::Permanent, Stage::DoubleDouble},
      {"half a double inside", {{0.5, 1 + 0x1p-52, 0}, 1}, shallow, Inside, Stage::Permanent, Stage::DoubleDouble},
      {"2^-201 outside", {{0, 0, 1}, 1}, wide, Outside, Stage::BigInteger, Stage::BigInteger},
  };
  expect_decided(cases, [](const Ball& ball, const filtered::PreparedPolygon& polygon, StageCounts& counts) {
    return filtered::foot(ball, polygon, counts);
  });
}

TEST(Stages, OfTheEdgesHit) {
  using Edges = std::vector<std::size_t>;
  const double k = 1'000;
  const auto of_large_l = [](const std::string& id, const Ball& ball, const Edges& expected, Stage stage) {
    return DecidedCase<Edges>{id, ball, large_l(), expected, stage, stage};
  };
  const std::vector<DecidedCase<Edges>> cases{
      of_large_l("none", {turned(10'000, 50'000, 0), 3 * k}, {}, Stage::Double),
      of_large_l("one", {turned(40'000, 1, 0), 3 * k}, {0}, Stage::Double),
      of_large_l("all", {turned(20'000, 20'000, 0), 300'000}, {0, 1, 2, 3, 4, 5}, Stage::Double),
      of_large_l("one, 3-4-5", {turned(40'000, -3 * k, 4 * k), 15 * k}, {0}, Stage::FixedInteger),
      of_large_l("both at the notch", {turned(25'000, 25'000, 0), 15 * k}, {2, 3}, Stage::FixedInteger),
      of_large_l("both at a vertex", {turned(-k, -2 * k, 2 * k), 9 * k}, {0, 5}, Stage::FixedInteger),
  };
  expect_decided(cases, [](const Ball& ball, const filtered::PreparedPolygon& polygon, StageCounts& counts) {
    return filtered::edges_hit(ball, polygon, counts);
  });
}

// Points and distances are never doubles alone: a vertex is as it was given, what is far from a tie between doubles is
// rounded from double-doubles, a tie by integers.
TEST(Stages, OfWholeAnswersAndClosestPoints) {
  const Polygon flat({{0, 0, 1}, {4, 0, 1}, {0, 4, 1}});
  const Polygon low({{-4, -4, -0x1p-53}, {4, -4, -0x1p-53}, {0, 4, -0x1p-53}});
  const struct {
    std::string id;
    Eigen::Vector3d center;
    Polygon polygon;
    filtered::ClosestPoint closest;
    Stage stage;
  } cases[] = {
      {"over a face", {1, 1, 3}, flat, {{Feature::Kind::Face, 0}, {1, 1, 1}, 2, {0, 0, 1}}, Stage::DoubleDouble},
      {"beside an edge",
       {2, -3, 4},
       right_triangle(),
       {{Feature::Kind::Edge, 0}, {2, 0, 0}, 5, {0, -0.6, 0.8}},
       Stage::DoubleDouble},
      {"off a vertex",
       {6, -1, 2},
       right_triangle(),
       {{Feature::Kind::Vertex, 1}, {4, 0, 0}, 3, {2.0 / 3, -1.0 / 3, 2.0 / 3}},
       Stage::DoubleDouble},
      {"a tie, 1 + 2^-53",
       {0, 0, 1},
       low,
       {{Feature::Kind::Face, 0}, {0, 0, -0x1p-53}, 1, {0, 0, 1}},
       Stage::BigInteger},
      {"a tie, 1 + 3 2^-53",
       {0, 0, 1 + 0x1p-52},
       low,
       {{Feature::Kind::Face, 0}, {0, 0, -0x1p-53}, 1 + 0x1p-51, {0, 0, 1}},
       Stage::BigInteger},
  };
  for (const auto& c : cases) {
    expect_decided(c.id + ", as a triangle", c.closest, c.stage, c.stage,
                   [&](StageCounts& counts) { return filtered::closest(c.center, triangle_of(c.polygon), counts); });
    const filtered::PreparedPolygon prepared(c.polygon);
    expect_decided(c.id + ", prepared", c.closest, c.stage, c.stage, [&](StageCounts& counts) {
      const Answer answer = filtered::answer({c.center, 0.75}, prepared, counts);
      return filtered::ClosestPoint{answer.nearest, answer.point, answer.distance, answer.contact_normal};
    });
  }
}

// A word for each, in order.
TEST(Stages, HaveTheWordsOfExplain) {
  EXPECT_EQ(to_string(Stage::Double), "double");
  EXPECT_EQ(to_string(Stage::Permanent), "permanent");
  EXPECT_EQ(to_string(Stage::DoubleDouble), "double-double");
  EXPECT_EQ(to_string(Stage::FixedInteger), "fixed-integer");
  EXPECT_EQ(to_string(Stage::BigInteger), "unlimited");
}

TEST(Stages, TheSlowestIsTheLast) {
  StageCounts counts;
  EXPECT_EQ(counts.last(), Stage::Double);
  counts.count(Stage::FixedInteger);
  counts.count(Stage::Double);
  EXPECT_EQ(counts.last(), Stage::FixedInteger);
  EXPECT_EQ(counts.decided_by(Stage::Double), 1U);
}

}  // namespace
}  // namespace touchstone::filtered_tests

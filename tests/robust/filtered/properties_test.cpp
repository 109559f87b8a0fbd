// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/filtered/filtered.h: (1) the answers of exact, (2) batches are single questions.
#include <gtest/gtest.h>
#include <rapidcheck/Random.h>
#include <rapidcheck/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "tests/robust/filtered/wrong_answers.h"
#include "tests/robust/support/hard_cases.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/rejection_code.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;

// What the generators of cases must not miss.
TEST(HardCases, HaveNegativeZeros) {
  // Coordinates of samples of workloads are hardly ever zero, nor are radii at a threshold.
  const std::vector<std::pair<std::string, rc::Gen<Case>>> all{{"grid_cases", grid_cases()},
                                                               {"soak_cases", soak_cases()},
                                                               {"threshold_cases", threshold_cases()},
                                                               {"degenerate_balls", degenerate_balls()},
                                                               {"off_plane_cases", off_plane_cases()},
                                                               {"scaled_cases", scaled_cases()},
                                                               {"islands", islands()},
                                                               {"hard_triangles", hard_triangles()}};
  for (const auto& [name, gen] : all) {
    NegativeZeros seen;
    rc::Random random(2026);
    for (int i = 0; i < 400; ++i) {
      const Case drawn = gen(random.split(), 100).value();
      seen.look_at(drawn.ball);
      seen.look_at(drawn.polygon);
    }
    EXPECT_TRUE(seen.center) << name;
    EXPECT_TRUE(seen.vertex) << name;
    EXPECT_TRUE(seen.radius || name == "threshold_cases") << name;
  }
}

/// Every question, against the one whole exact answer.
void expect_exact_answers(const Case& c) {
  const std::string wrong =
      wrong_answers(c.ball, filtered::PreparedPolygon(c.polygon), exact::answer(c.ball, c.polygon));
  RC_ASSERT(wrong == "");
}

/// The overloads with counts; each counts at least one decision.
void expect_exact_answers_counted(const Case& c) {
  const Answer truth = exact::answer(c.ball, c.polygon);
  const filtered::PreparedPolygon prepared(c.polygon);
  const auto asked = [&](const auto& question) {
    filtered::StageCounts counts;
    auto answer = question(counts);
    std::uint64_t decisions = 0;
    for (std::size_t stage = 0; stage < filtered::kStages; ++stage)
      decisions += counts.decided_by(static_cast<filtered::Stage>(stage));
    RC_ASSERT(decisions > 0U);
    return answer;
  };
  using Counts = filtered::StageCounts;
  RC_ASSERT(asked([&](Counts& n) { return filtered::answer(c.ball, prepared, n); }) == truth);
  RC_ASSERT(asked([&](Counts& n) { return filtered::contact(c.ball, prepared, n); }) == truth.contact());
  RC_ASSERT(asked([&](Counts& n) { return filtered::relation(c.ball, prepared, n); }) == truth.relation);
  RC_ASSERT(asked([&](Counts& n) { return filtered::plane_side(c.ball, prepared, n); }) == truth.plane);
  RC_ASSERT(asked([&](Counts& n) { return filtered::foot(c.ball, prepared, n); }) == truth.foot);
  RC_ASSERT(asked([&](Counts& n) { return filtered::edges_hit(c.ball, prepared, n); }) == truth.edges_hit);
}

// Guarantee (1), where the inputs come from elsewhere: samples of all families and placements, small grids.
RC_GTEST_PROP(FilteredIsExact, OnSamplesAndGrids, ()) { expect_exact_answers(*any_case()); }

RC_GTEST_PROP(FilteredIsExact, OnTheCasesOfTheSoak, ()) { expect_exact_answers(*soak_cases()); }

RC_GTEST_PROP(FilteredIsExact, AtThresholdsDoubleByDouble, ()) { expect_exact_answers(*threshold_cases()); }

RC_GTEST_PROP(FilteredIsExact, ForDegenerateBalls, ()) { expect_exact_answers(*degenerate_balls()); }

RC_GTEST_PROP(FilteredIsExact, OffPlane, ()) { expect_exact_answers(*off_plane_cases()); }

RC_GTEST_PROP(FilteredIsExact, AtExtremeScales, ()) { expect_exact_answers(*scaled_cases()); }

RC_GTEST_PROP(FilteredIsExact, OnIslandsInHoles, ()) { expect_exact_answers(*islands()); }

RC_GTEST_PROP(FilteredIsExact, OnTangentBallsOfTheLattice, ()) {
  expect_exact_answers(*samples(
      {.balls = {workloads::BallPlace::LatticeTangent}, .most_holes = 3, .largest_warp = 0, .largest_exponent = 1000}));
}

RC_GTEST_PROP(FilteredIsExact, UnpreparedToo, ()) {
  const Case c = *hard_cases();
  RC_ASSERT(wrong_answers(c.ball, c.polygon, exact::answer(c.ball, c.polygon)) == "");
}

RC_GTEST_PROP(FilteredIsExact, CountedToo, ()) { expect_exact_answers_counted(*hard_cases()); }

RC_GTEST_PROP(FilteredTriangle, IsExactInEveryOrderOfItsVertices, ()) {
  const Case c = *hard_triangles();
  const bool touches = exact::contact(c.ball, c.polygon);
  const Triangle t = triangle_of(c.polygon);
  const Triangle orders[] = {{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b},
                             {t.c, t.b, t.a}, {t.b, t.a, t.c}, {t.a, t.c, t.b}};
  for (const Triangle& order : orders) {
    filtered::StageCounts counts;
    RC_ASSERT(filtered::contact(c.ball, order) == touches);
    RC_ASSERT(filtered::contact(c.ball, order, counts) == touches);
  }
}

// Neither mirrors nor exchanged axes change a contact; vector lanes and dropped axes do change.
RC_GTEST_PROP(FilteredTriangle, IsExactUnderMirrorsAndExchangedAxes, ()) {
  const Case c = *hard_triangles();
  const bool touches = exact::contact(c.ball, c.polygon);
  for (int image = 0; image < 24; ++image) {
    const Case turned = moved(c, [image](const Eigen::Vector3d& v) {
      const int first = image % 3;
      Eigen::Vector3d w(v[first], v[(first + 1) % 3], v[(first + 2) % 3]);
      for (int axis = 0; axis < 3; ++axis)
        if (image / 3 >> axis & 1) w[axis] = -w[axis];
      return w;
    });
    RC_ASSERT(filtered::contact(turned.ball, triangle_of(turned.polygon)) == touches);
    RC_ASSERT(filtered::contact(turned.ball, filtered::PreparedPolygon(turned.polygon)) == touches);
  }
}

/// An array of bools that a span can be taken of.
struct Touches {
  explicit Touches(std::size_t count) : size(count), data(std::make_unique<bool[]>(count + 1)) { data[count] = true; }
  std::span<bool> span() { return {data.get(), size}; }
  /// Nothing may be written behind the span.
  [[nodiscard]] bool intact() const { return data[size]; }

  std::size_t size;
  std::unique_ptr<bool[]> data;
};

// Guarantee (2): of any length, the lanes of a batch do not know each other.
RC_GTEST_PROP(FilteredBatch, OfTrianglesIsSingleQuestions, ()) {
  const std::size_t count = *rc::gen::resize(100, rc::gen::inRange<std::size_t>(0, 40));
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < count; ++i) triangles.push_back(triangle_of((*hard_triangles()).polygon));
  const Case c = *hard_triangles();
  if (count > 0) triangles[count / 2] = triangle_of(c.polygon);
  Touches touches(count);
  filtered::contact(c.ball, triangles, touches.span());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, d] = triangles[i];
    RC_ASSERT(touches.data[i] == exact::contact(c.ball, Polygon({a, b, d})));
    RC_ASSERT(touches.data[i] == filtered::contact(c.ball, triangles[i]));
  }
  RC_ASSERT(touches.intact());
}

RC_GTEST_PROP(FilteredBatch, OfBallsIsSingleQuestions, ()) {
  const Case c = *hard_cases();
  const exact::PreparedPolygon truth(c.polygon);
  const filtered::PreparedPolygon prepared(c.polygon);
  const std::size_t count = *rc::gen::resize(100, rc::gen::inRange<std::size_t>(0, 40));
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < count; ++i) {
    Ball ball = c.ball;
    const auto steps = static_cast<std::int64_t>(i) - static_cast<std::int64_t>(count / 2);
    if (i % 3 != 2) ball.radius = workloads::move_radius_by_doubles(ball.radius, steps);
    if (i % 3 == 1) ball.center[static_cast<int>(i / 3 % 3)] = c.polygon.vertex(i % c.polygon.vertex_count()).x();
    balls.push_back(ball);
  }
  Touches touches(count);
  filtered::contact(balls, prepared, touches.span());
  for (std::size_t i = 0; i < count; ++i) {
    RC_ASSERT(touches.data[i] == exact::contact(balls[i], truth));
    RC_ASSERT(touches.data[i] == filtered::contact(balls[i], prepared));
  }
  RC_ASSERT(touches.intact());
}

TEST(FilteredPrepared, RefusesLoopsWithoutANormal) {
  const Polygon line({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}});
  EXPECT_EQ(rejection_code([&] { const filtered::PreparedPolygon prepared(line); }), "zero-normal");
}

// A box hierarchy over thousands of edges, asked about everywhere along the outline.
TEST(FilteredPrepared, IsExactOnThousandsOfVertices) {
  for (const auto family :
       {workloads::Family::Koch, workloads::Family::Comb, workloads::Family::Spiral, workloads::Family::Star})
    for (const auto place : workloads::all_ball_places()) {
      const workloads::Workload workload{
          .family = family, .placement = workloads::Placement::LatticeFrame, .ball = place, .vertices = 2000};
      const workloads::Sample sample = workloads::sample(workload, 2008, 1);
      const filtered::PreparedPolygon prepared(sample.polygon);
      const exact::PreparedPolygon truth(sample.polygon);
      for (const std::int64_t steps : {-1, 0, 1}) {
        const Ball ball{sample.ball.center, workloads::move_by_doubles(sample.ball.radius, steps)};
        EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "") << sample.id << " moved by " << steps;
      }
    }
}

// A moved-from polygon leaves its parts behind; the one moved to answers on.
TEST(FilteredPrepared, CanBeMoved) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const Ball ball{{2, 2, 1}, 1};
  filtered::PreparedPolygon first(square);
  filtered::PreparedPolygon second(std::move(first));
  EXPECT_EQ(filtered::answer(ball, second), exact::answer(ball, square));
  first = std::move(second);
  EXPECT_EQ(filtered::answer(ball, first), exact::answer(ball, square));
}

}  // namespace
}  // namespace touchstone::filtered_tests

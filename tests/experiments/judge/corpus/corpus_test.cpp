// SPDX-License-Identifier: GPL-3.0-or-later
// Compares all implementations of the project with the corpus, through every interface. The corpus detects planted bugs
// (tests/system/mutants/run.py --corpus).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "experiments/cases/comparison.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/studies/soak/system_under_test.h"
#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/motion.h"
#include "tests/experiments/judge/corpus/stored.h"
#include "tests/robust/support/environment.h"

namespace touchstone::corpus {
namespace {

const soak::SystemUnderTest filtered_path;

std::optional<Triangle> triangle_of(const Polygon& polygon) {
  if (polygon.vertex_count() != 3) return std::nullopt;
  return Triangle{polygon.vertex(0), polygon.vertex(1), polygon.vertex(2)};
}

/// Keys that say yes or no, which or how many.
bool decisive_keys_agree(const Answer& a, const Answer& b) {
  return a.plane == b.plane && a.plane_tangent == b.plane_tangent && a.foot == b.foot && a.edges_hit == b.edges_hit &&
         a.relation == b.relation && a.nearest == b.nearest;
}

/// Zeros in answers are +0, which a comparison by value does not tell from -0.
template <class Closest>
bool zeros_are_positive(const Closest& answer) {
  const auto is_positive = [](double number) { return number != 0 || !std::signbit(number); };
  return is_positive(answer.distance) && std::ranges::all_of(answer.point, is_positive);
}

TEST(Corpus, EveryLineIsRejectedOrNotAsItExpects) {
  for (const Stored& stored : stored_cases()) {
    const auto* rejection = std::get_if<Rejection>(&stored.read.content);
    ASSERT_TRUE(stored.read.expected) << stored;
    ASSERT_EQ(rejection != nullptr, stored.read.expected->rejects()) << stored;
    if (rejection == nullptr) continue;
    ASSERT_TRUE(cases::differences(*stored.read.expected, cases::stated(*rejection)).empty()) << stored;
  }
}

TEST(Corpus, ExactMeetsEveryCase) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const exact::PreparedPolygon polygon(stored.polygon());
    const Ball& ball = stored.ball();
    const Answer& expected = *stored.answer;
    const Answer answer = exact::answer(ball, polygon);
    ASSERT_EQ(answer, expected) << stored;
    ASSERT_TRUE(zeros_are_positive(answer)) << stored;
    ASSERT_EQ(exact::contact(ball, polygon), expected.contact()) << stored;
    ASSERT_EQ(exact::relation(ball, polygon), expected.relation) << stored;
    ASSERT_EQ(exact::plane_side(ball, polygon), expected.plane) << stored;
    ASSERT_EQ(exact::foot(ball, polygon), expected.foot) << stored;
    ASSERT_EQ(exact::edges_hit(ball, polygon), expected.edges_hit) << stored;
  }
}

TEST(Corpus, FastFailsWhereItsTagSaysSoAlone) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const Answer answer = fast::answer(stored.ball(), stored.polygon());
    ASSERT_EQ(decisive_keys_agree(answer, *stored.answer), !stored.fails("fast")) << stored;
    if (!stored.fails("fast")) {
      ASSERT_EQ(fast::contact(stored.ball(), stored.polygon()), stored.answer->contact()) << stored;
    }
  }
}

TEST(Corpus, ExactMeetsEveryMovingCase) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.first) continue;
    const Asked asked(stored);
    const exact::PreparedPolygon polygon(stored.polygon());
    ASSERT_EQ(exact::first_contact(stored.motion(), polygon), *stored.first) << stored;
    ASSERT_EQ(exact::contact(stored.motion(), polygon), stored.first->contact()) << stored;
  }
}

TEST(Corpus, FilteredMeetsEveryMovingCaseInEveryEnvironment) {
  using contact_tests::Environment;
  for (const Stored& stored : stored_cases()) {
    if (!stored.first) continue;
    const Asked asked(stored);
    const filtered::PreparedPolygon polygon(stored.polygon());
    const auto triangle = triangle_of(stored.polygon());
    const Motion motion = stored.motion();
    for (const int mode : contact_tests::kModes)
      for (const unsigned flush : {Environment::kKeep, Environment::kBoth}) {
        bool touches = false, touches_triangle = stored.first->contact();
        FirstContact first, first_triangle = *stored.first;
        {
          const Environment changed(mode, flush);
          touches = filtered::contact(motion, polygon);
          first = filtered::first_contact(motion, polygon);
          if (triangle) {
            touches_triangle = filtered::contact(motion, *triangle);
            first_triangle = filtered::first_contact(motion, *triangle);
          }
        }
        ASSERT_EQ(touches, stored.first->contact()) << stored;
        ASSERT_EQ(touches_triangle, stored.first->contact()) << stored;
        ASSERT_EQ(first, *stored.first) << stored;
        ASSERT_EQ(first_triangle, *stored.first) << stored;
      }
  }
}

TEST(Corpus, FastFailsMovingCasesWhereItsTagSaysSoAlone) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.first) continue;
    const Asked asked(stored);
    const FirstContact found = fast::first_contact(stored.motion(), stored.polygon()), &truth = *stored.first;
    const bool agrees = found.kind == truth.kind && found.momentary == truth.momentary &&
                        (!truth.contact() || found.feature == truth.feature);
    ASSERT_EQ(agrees, !stored.fails("fast")) << stored;
  }
}

// The hand-made cases of ordinary size have small integers, for which doubles round nothing that affects decisions.
TEST(Corpus, FastMeetsTheHandMadeCasesOfOrdinarySize) {
  int compared = 0;
  for (const Stored& stored : stored_cases()) {
    if (stored.file != "features") continue;
    const auto named = [&](const char* part) { return stored.id.find(part) != std::string::npos; };
    const Ball& ball = stored.ball();
    const bool ordinary = !named("scale-") && !named("double") && !named("-tie") && !named("lift") &&
                          ball.center.cwiseAbs().maxCoeff() < 1e9 && ball.radius > 1e-9;
    if (!ordinary && stored.id != "edge-before-vertex-on-a-tie") continue;
    ++compared;
    const Polygon& polygon = stored.polygon();
    const Answer answer = fast::answer(ball, polygon);
    const Answer& truth = *stored.answer;
    EXPECT_EQ(answer.plane, truth.plane) << stored;
    EXPECT_EQ(answer.foot, truth.foot) << stored;
    EXPECT_EQ(answer.edges_hit, truth.edges_hit) << stored;
    EXPECT_EQ(answer.relation, truth.relation) << stored;
    EXPECT_EQ(answer.nearest, truth.nearest) << stored;
    EXPECT_EQ(answer.point, truth.point) << stored;
    EXPECT_EQ(answer.distance, truth.distance) << stored;
    EXPECT_EQ(fast::contact(ball, polygon), truth.contact()) << stored;
    EXPECT_EQ(fast::relation(ball, polygon), truth.relation) << stored;
  }
  EXPECT_GE(compared, 25);
}

TEST(Corpus, FilteredMeetsEveryCaseAsATriangle) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const auto triangle = triangle_of(stored.polygon());
    if (!triangle) continue;
    const auto& [a, b, c] = *triangle;
    const Ball& ball = stored.ball();
    const Answer& expected = *stored.answer;
    const bool touches = expected.contact();
    filtered::StageCounts counts;
    filtered::NoCounts none;
    ASSERT_EQ(filtered_path.contact(ball, *triangle), touches) << stored;
    ASSERT_EQ(filtered_path.contact(ball, *triangle, counts), touches) << stored;
    ASSERT_EQ(filtered_path.plain_contact(ball, *triangle), touches) << stored;
    const std::array<Triangle, 6> orders{{{a, b, c}, {b, c, a}, {c, a, b}, {c, b, a}, {b, a, c}, {a, c, b}}};
    std::array<bool, 6> found{};
    filtered_path.contact(ball, orders, found);
    ASSERT_EQ(std::ranges::count(found, touches), 6) << stored;
    for (const Triangle& order : orders) ASSERT_EQ(filtered_path.plain_contact(ball, order), touches) << stored;
    ASSERT_EQ(filtered::relation(ball, *triangle), expected.relation) << stored;

    const filtered::ClosestPoint closest{expected.nearest, expected.point, expected.distance, expected.contact_normal};
    ASSERT_EQ(filtered::closest(ball.center, *triangle), closest) << stored;
    const auto found_closest =
        filtered::detail::closest(filtered::detail::baseline_kernels().plain, ball.center, *triangle, none);
    ASSERT_EQ(found_closest, closest) << stored;
    ASSERT_TRUE(zeros_are_positive(found_closest)) << stored;
  }
}

TEST(Corpus, FilteredMeetsEveryCaseAsAPreparedPolygon) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const filtered::PreparedPolygon polygon(stored.polygon());
    const Ball& ball = stored.ball();
    const Answer& expected = *stored.answer;
    filtered::StageCounts counts;
    ASSERT_EQ(filtered_path.contact(ball, polygon), expected.contact()) << stored;
    ASSERT_EQ(filtered_path.contact(ball, polygon, counts), expected.contact()) << stored;
    ASSERT_EQ(filtered_path.plain_contact(ball, polygon), expected.contact()) << stored;
    ASSERT_EQ(filtered_path.relation(ball, polygon), expected.relation) << stored;
    ASSERT_EQ(filtered_path.plane_side(ball, polygon), expected.plane) << stored;
    ASSERT_EQ(filtered_path.foot(ball, polygon), expected.foot) << stored;
    ASSERT_EQ(filtered_path.edges_hit(ball, polygon), expected.edges_hit) << stored;
    ASSERT_EQ(filtered_path.answer(ball, polygon), expected) << stored;
    ASSERT_EQ(filtered_path.answer(ball, polygon, counts), expected) << stored;
    const Answer answer = filtered_path.plain_answer(ball, polygon);
    ASSERT_EQ(answer, expected) << stored;
    ASSERT_TRUE(zeros_are_positive(answer)) << stored;
  }
}

// Queries walk the hierarchy only where a polygon has many edges, and few polygons of the corpus do.
TEST(Corpus, FilteredMeetsEveryCaseByTheHierarchyOfEdges) {
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const filtered::PreparedPolygon::Parts parts(stored.polygon(), filtered::detail::EdgeIndex::Use::OftenByHierarchy);
    for (const filtered::detail::Kernels* kernels :
         {&filtered::detail::baseline_kernels(), &filtered::detail::kernels()}) {
      filtered::NoCounts none;
      ASSERT_EQ(kernels->plain.contact(stored.ball(), parts, none), stored.answer->contact()) << stored;
      ASSERT_EQ(kernels->plain.answer(stored.ball(), parts, none), *stored.answer) << stored;
    }
  }
}

// Radii on both sides of the stored distance, which is the double nearest to the exact one: two doubles away the answer
// is known without an oracle. Nine balls, so that vectors of 2, 4 and 8 leave a remainder of one.
TEST(Corpus, FilteredMeetsEveryCaseInABatch) {
  for (const Stored& stored : stored_cases()) {
    const Asked asked(stored);
    if (!stored.answer || !(stored.answer->distance > 0x1p-1060 && stored.answer->distance < 0x1p1020)) continue;
    const filtered::PreparedPolygon polygon(stored.polygon());
    std::array<Ball, 9> balls;
    std::array<bool, 9> expected{}, found{};
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int64_t steps = i < 4 ? static_cast<std::int64_t>(i) - 5 : static_cast<std::int64_t>(i) - 2;
      balls[i] = {stored.ball().center, workloads::move_by_doubles(stored.answer->distance, steps)};
      expected[i] = steps > 0;
    }
    balls[8] = stored.ball();
    expected[8] = stored.answer->contact();
    filtered_path.contact(balls, polygon, found);
    ASSERT_EQ(found, expected) << stored;
  }
}

// Prepares and queries in each environment. The comparison with the corpus takes place in the original environment,
// since a comparison under flush-to-zero treats subnormals as zero.
TEST(Corpus, FilteredMeetsEveryCaseInEveryEnvironment) {
  using contact_tests::Environment;
  for (const Stored& stored : stored_cases()) {
    if (!stored.answer) continue;
    const Asked asked(stored);
    const filtered::PreparedPolygon polygon(stored.polygon());
    const auto triangle = triangle_of(stored.polygon());
    const Ball& ball = stored.ball();
    for (const int mode : contact_tests::kModes)
      for (const unsigned flush : {Environment::kKeep, Environment::kBoth}) {
        bool as_triangle = stored.answer->contact(), as_polygon = false;
        const Answer answer = [&] {
          const Environment changed(mode, flush);
          if (triangle) as_triangle = filtered_path.plain_contact(ball, *triangle);
          as_polygon = filtered_path.plain_contact(ball, polygon);
          return filtered_path.plain_answer(ball, polygon);
        }();
        ASSERT_EQ(as_triangle, stored.answer->contact()) << stored;
        ASSERT_EQ(as_polygon, stored.answer->contact()) << stored;
        ASSERT_EQ(answer, *stored.answer) << stored;
      }
  }
}

}  // namespace
}  // namespace touchstone::corpus

// SPDX-License-Identifier: GPL-3.0-or-later
// The other methods: exact methods are exact, sure answers are right, and queries have no side effects.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "experiments/cases/comparison.h"
#include "experiments/cases/crossings.h"
#include "experiments/cases/method.h"
#include "experiments/cases/verdict.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "experiments/thesis/convex/convex.h"
#include "robust/exact/exact.h"
#include "tests/robust/support/generators.h"

namespace touchstone::methods {
namespace {

// The program adds these, too, before it asks for any method.
[[maybe_unused]] const bool kAdded = (convex::add_methods(), true);

using workloads::BallPlace;
using workloads::Placement;

struct Sample {
  std::string id;
  Ball ball;
  Polygon polygon;
};

/// Every family, placement and place of the ball, with and without holes, a few doubles from the threshold.
std::vector<Sample> adversarial_samples() {
  std::vector<Sample> samples;
  std::uint64_t index = 0;
  for (const auto family : workloads::all_families())
    for (const auto placement : {Placement::LatticeFrame, Placement::Rotated})
      for (const auto place : workloads::all_ball_places()) {
        if (place == BallPlace::LatticeTangent && placement == Placement::Rotated) continue;
        workloads::Workload workload{.family = family, .placement = placement, .ball = place};
        workload.doubles = static_cast<int>(index % 5) - 2;
        if (family == workloads::Family::Star && index % 2 == 0) workload.holes = 2;
        auto sample = workloads::sample(workload, 11, index++);
        samples.push_back({sample.id, sample.ball, std::move(sample.polygon)});
      }
  return samples;
}

/// Polygons whose vertices are off their plane, by a unit in the last place up to a tenth of the size.
std::vector<Sample> off_plane_samples() {
  std::vector<Sample> samples;
  std::uint64_t index = 0;
  for (const auto& off_plane : bench::all_off_plane())
    for (const auto family : bench::outlines_of(16)) {
      const Polygon polygon = bench::move_off_plane(bench::draw_polygon(family, 16, 5, index), off_plane, 5, index);
      for (const auto& query : bench::draw_balls({polygon}, 5 + index, 4)) {
        Ball ball = query.ball;
        const double distance = exact::answer(ball, polygon).distance;
        ball.radius = workloads::move_by_doubles(distance, static_cast<std::int64_t>(index % 3));
        samples.push_back({off_plane.name + " off, number " + std::to_string(index), ball, polygon});
        ++index;
      }
    }
  return samples;
}

std::vector<Sample> all_samples() {
  std::vector<Sample> samples = adversarial_samples();
  for (Sample& sample : off_plane_samples()) samples.push_back(std::move(sample));
  return samples;
}

cases::Json ask(std::string_view method, const Sample& sample, cases::QueryKind kind = cases::QueryKind::Answer) {
  return cases::object_of(find_method(method)->prepare(sample.polygon)->ask(sample.ball, kind));
}

/// Leaves out what only `exact`, `filtered` and `fast` compute.
cases::Json without_normal(cases::Json answer) {
  answer.erase("contact_normal"), answer.erase("depth");
  return answer;
}

/// Determines the rounding mode by sums: fegetround reads only the x87 unit.
bool rounds_to_nearest() {
  const volatile double one = 1, little = 0x1p-60;
  return one + little == one && one - little == one;
}

constexpr std::array kKinds{cases::QueryKind::Contact, cases::QueryKind::Relation, cases::QueryKind::PlaneSide,
                            cases::QueryKind::Foot,    cases::QueryKind::EdgesHit, cases::QueryKind::Answer};

TEST(Methods, CannotBeAddedOnceOneIsAskedFor) {
  const std::size_t count = all_methods().size();
  EXPECT_THROW(add_methods([](MethodList&) {}), std::logic_error);
  EXPECT_EQ(all_methods().size(), count);
}

// Every key of every query, off the plane, too.
TEST(ExactMethods, AgreeWithExactOnAdversarialSamples) {
  for (const Sample& sample : all_samples())
    for (const cases::QueryKind kind : kKinds) {
      const auto truth = ask("exact", sample, kind);
      EXPECT_EQ(ask("filtered", sample, kind), truth) << sample.id;
      for (const char* method : {"cgal-epeck", "rational"})
        EXPECT_EQ(ask(method, sample, kind), without_normal(truth)) << method << ", " << sample.id;
    }
}

// Sure answers are right, key by key. A method reports unsure if and only if a key is missing.
TEST(Interval, IsNeverWrongWhereItIsSure) {
  std::uint64_t sure = 0, unsure = 0;
  for (const Sample& sample : all_samples()) {
    const auto prepared = find_method("interval")->prepare(sample.polygon);
    for (const cases::QueryKind kind : kKinds) {
      const cases::PartialAnswer answer = prepared->ask(sample.ball, kind);
      ASSERT_TRUE(rounds_to_nearest()) << sample.id;  // bounds come from no mode that was left behind
      const auto given = cases::object_of(answer), truth = without_normal(ask("exact", sample, kind));
      for (const auto& [key, value] : given.items()) EXPECT_EQ(value, truth[key]) << key << ", " << sample.id;
      EXPECT_EQ(answer.unsure, given.size() < truth.size()) << sample.id;
      if (kind == cases::QueryKind::Contact) ++(answer.unsure ? unsure : sure);
    }
  }
  EXPECT_GT(sure, 20U);
  EXPECT_GT(unsure, 20U);
}

// The same on any case of the generators: grids, far away, warped, at extreme exponents.
RC_GTEST_PROP(Methods, ThatAreExactOrSureAreRightOnAnyCase, ()) {
  const auto drawn = *contact_tests::any_case();
  const auto truth =
      without_normal(cases::object_of(cases::PartialAnswer::of(exact::answer(drawn.ball, drawn.polygon), "")));
  const Sample sample{drawn.id, drawn.ball, drawn.polygon};
  RC_ASSERT(ask("cgal-epeck", sample) == truth);
  RC_ASSERT(ask("rational", sample) == truth);
  const auto sure = ask("interval", sample);
  for (const auto& [key, value] : sure.items()) RC_ASSERT(value == truth[key]);
}

// If every product and quotient is a double, intervals are points, and every answer is sure.
TEST(Interval, KnowsAllThatDoublesHold) {
  const Polygon u({{0, -1, 0}, {4, -1, 0}, {4, 4, 0}, {2, 4, 0}, {2, 0, 0}, {1, 0, 0}, {1, 4, 0}, {0, 4, 0}});
  const Sample sample{"U", {{1.5, 2, 0}, 0.5}, u};
  EXPECT_EQ(ask("interval", sample), without_normal(ask("exact", sample)));
}

// Beside a threshold by no more than two doubles, double-doubles and 201 bits are right.
TEST(Mpfr, IsRightBesideThresholds) {
  const auto *wide = find_method("fast-mpfr-201"), *narrow = find_method("fast-double-double");
  for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
    if (!cases::moves_radius(cases::all_strata()[s].threshold)) continue;
    const auto crossing = cases::draw_crossing({s, {}, 9, 0}, *methods::find_method("exact"));
    ASSERT_TRUE(crossing);
    const auto by_wide = wide->prepare(crossing->polygon), by_narrow = narrow->prepare(crossing->polygon);
    for (std::size_t i = 0; i < crossing->balls.size(); ++i) {
      const double offset = cases::all_offsets()[crossing->offsets[i]];
      if (offset == 0) continue;
      const auto truth = crossing->truths[i].contact;
      EXPECT_EQ(by_narrow->ask(crossing->balls[i], cases::QueryKind::Contact).contact, truth) << s << " " << offset;
      EXPECT_EQ(by_wide->ask(crossing->balls[i], cases::QueryKind::Contact).contact, truth) << s << " " << offset;
    }
  }
}

// No scalar is computed in a narrower one on the way: each wider scalar gets more thresholds right.
TEST(FastScalars, ErrLessTheWiderTheyAre) {
  std::vector<std::uint64_t> wrong;
  for (const char* name : {"fast-float", "fast", "fast-long-double", "fast-double-double"}) {
    wrong.push_back(0);
    for (std::size_t s = 0; s < cases::all_strata().size(); ++s) {
      if (cases::all_strata()[s].threshold != cases::Threshold::Face) continue;
      const auto crossing = cases::draw_crossing({s, {}, 2, 0}, *methods::find_method("exact"));
      ASSERT_TRUE(crossing);
      const auto prepared = find_method(name)->prepare(crossing->polygon);
      for (std::size_t i = 0; i < crossing->balls.size(); ++i)
        if (prepared->ask(crossing->balls[i], cases::QueryKind::Contact).contact != crossing->truths[i].contact)
          ++wrong.back();
    }
  }
  for (std::size_t i = 1; i < wrong.size(); ++i) EXPECT_LT(wrong[i], wrong[i - 1]) << i;
}

TEST(AllMethods, HaveNamesOfTheirOwnAndAnswerThePlainestCase) {
  const Polygon square({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  std::set<std::string_view> names;
  for (const auto& method : all_methods()) {
    EXPECT_TRUE(names.insert(method->name()).second) << method->name();
    EXPECT_LE(method->summary().size(), 96U) << method->name();
    const auto prepared = method->prepare(square);
    const cases::PartialAnswer whole = prepared->ask({{1, 1, 1}, 1.25}, cases::QueryKind::Answer);
    EXPECT_FALSE(whole.unsure) << method->name();
    EXPECT_TRUE(whole.contact || whole.foot) << method->name() << " answers nothing";
    if (whole.contact) {
      EXPECT_TRUE(*whole.contact) << method->name();
      EXPECT_EQ(prepared->ask({{1, 1, 1}, 1.25}, cases::QueryKind::Contact).contact, true) << method->name();
      EXPECT_EQ(prepared->ask({{1, 1, 1}, 0.75}, cases::QueryKind::Contact).contact, false) << method->name();
    }
    // Third-party engines answer one of these queries, ours all.
    EXPECT_EQ(whole.foot.value_or(PointLocation::Inside), PointLocation::Inside) << method->name();
    EXPECT_EQ(whole.plane.value_or(PlaneSide::Intersects), PlaneSide::Intersects) << method->name();
    EXPECT_EQ(whole.edges_hit.value_or(std::vector<std::size_t>{}), std::vector<std::size_t>{}) << method->name();
  }
}

// Intervals round upwards while they compute, and only then.
// Planes, feet and squares of such numbers overflow; exact predicates of what is not finite would end the program.
TEST(AllMethods, ContinueWhenNumbersOverflow) {
  const std::set<std::string_view> exact_ones{"exact", "filtered", "rational", "cgal-epeck"};
  for (const double size : {1e100, 1e155, 1e200, 1e300, 0x1p1022}) {
    const Polygon triangle({{0, 0, 0}, {size, 0, size / 4}, {0, size, 0}});
    for (const Ball& ball : {Ball{{size / 3, size / 3, size}, size / 2}, Ball{{1, 1, 1}, size}, Ball{{-size, 0, 0}, 1}})
      for (const auto& method : all_methods()) {
        const auto answer = method->prepare(triangle)->ask(ball, cases::QueryKind::Answer);
        if (exact_ones.count(method->name()) == 1) {
          EXPECT_EQ(answer.contact, exact::contact(ball, triangle)) << method->name() << ", " << size;
        }
      }
  }
}

TEST(AllMethods, LeaveTheRoundingModeAsItWas) {
  for (const Sample& sample : adversarial_samples())
    for (const auto& method : all_methods()) {
      const auto prepared = method->prepare(sample.polygon);
      ASSERT_TRUE(rounds_to_nearest()) << method->name();
      (void)prepared->ask(sample.ball, cases::QueryKind::Answer);
      ASSERT_TRUE(rounds_to_nearest()) << method->name();
    }
}

// Queries of one thread do not disturb another, although they share lazy numbers, which change.
TEST(AllMethods, MayBeAskedFromSeveralThreads) {
  workloads::Workload workload{.placement = Placement::Rotated, .ball = BallPlace::NearEdge};
  const auto sample = workloads::sample(workload, 1, 0);
  for (const auto& method : all_methods()) {
    const auto alone = cases::object_of(method->prepare(sample.polygon)->ask(sample.ball, cases::QueryKind::Answer));
    const auto shared = method->prepare(sample.polygon);
    std::array<cases::Json, 4> answers;
    {
      std::vector<std::jthread> threads;
      for (auto& answer : answers)
        threads.emplace_back([&] { answer = cases::object_of(shared->ask(sample.ball, cases::QueryKind::Answer)); });
    }
    for (const auto& answer : answers) EXPECT_EQ(answer, alone) << method->name();
  }
}

}  // namespace
}  // namespace touchstone::methods

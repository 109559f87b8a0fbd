// SPDX-License-Identifier: GPL-3.0-or-later
// The study of moving balls: its thresholds are thresholds, it counts planted errors as what they are, and its data
// depend on the settings alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/motions/measure.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/planted_method.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::motions {
namespace {

using cases::PartialAnswer;
using run_tests::kNeverStop;
using run_tests::kSilent;
using run_tests::Scratch;

TEST(GrazingRadius, IsTheLeastDoubleThatTouches) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const auto touches = [&](const Motion& motion) { return exact::contact(motion, square); };
  const auto radius = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return workloads::grazing_radius({{from, 7}, to}, touches);
  };
  EXPECT_EQ(radius({-1, 2, -4}, {-1, 2, 4}), 1);
  EXPECT_EQ(radius({2, 2, 3}, {2, 2, 2}), 2);
  EXPECT_EQ(radius({2, 2, 3}, {2, 2, -3}), 0);
  const double root = radius({-1, -1, -4}, {-1, -1, 4});
  EXPECT_GE(root * root, 2);
  EXPECT_LT(std::nextafter(root, 0.0) * std::nextafter(root, 0.0), 2);
}

// An estimate, however wrong, changes the number of questions only.
TEST(GrazingRadius, IsTheSameFromEveryEstimate) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  int questions = 0;
  const auto touches = [&](const Motion& motion) {
    ++questions;
    EXPECT_GE(motion.ball.radius, 0);
    return exact::contact(motion, square);
  };
  const double largest = std::numeric_limits<double>::max();
  for (const Motion& motion : {Motion{{{-1, -1, -4}, 7}, {-1, -1, 4}}, Motion{{{2, 2, 3}, 7}, {2, 2, -3}},
                               Motion{{{2, 2, 3}, 7}, {2, 2, 0x1p-1074}}}) {
    const double radius = workloads::grazing_radius(motion, touches);
    for (const double estimate : {0.0, 0x1p-1074, radius, std::nextafter(radius, 0.0), std::nextafter(radius, largest),
                                  radius + 0x1p-40, radius / 2, 1e300, largest})
      EXPECT_EQ(workloads::grazing_radius(motion, touches, estimate), radius) << estimate;
    questions = 0;
    (void)workloads::grazing_radius(motion, touches, radius);
    EXPECT_LE(questions, 2);
  }
}

TEST(Threshold, SeparatesTwoDoublesAndIsNamedByWhatHappensThere) {
  std::set<Event> events;
  std::set<Feature::Kind> features;
  for (std::size_t stratum = 0; stratum < all_strata().size(); ++stratum)
    for (std::uint64_t n = 0; n < 4; ++n) {
      const auto at = draw_at_threshold(stratum, 8, 3, n);
      if (!at) continue;
      EXPECT_GE(workloads::extent_of(at->polygon), 1);
      EXPECT_LT(workloads::extent_of(at->polygon), 2);
      const double radius = at->motion.ball.radius;
      EXPECT_TRUE(exact::contact(at->motion, at->polygon));
      EXPECT_FALSE(exact::contact(workloads::with_radius(at->motion, std::nextafter(radius, 0.0)), at->polygon));
      EXPECT_EQ(exact::first_contact(at->motion, at->polygon).feature.kind, at->feature);
      EXPECT_EQ(exact::contact(at->motion.ball, at->polygon), at->event == Event::Start);
      if (at->event == Event::End) {
        EXPECT_TRUE(exact::contact(Ball{at->motion.to, radius}, at->polygon));
      }
      events.insert(at->event);
      features.insert(at->feature);
    }
  EXPECT_EQ(events.size(), 3U);
  EXPECT_EQ(features.size(), 3U);
}

TEST(Threshold, IsMovedBySharesOfTheExtent) {
  const Polygon square({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
  const auto at = find_threshold(square, {{{-1, 2, -4}, 0}, {-1, 2, 4}});
  ASSERT_TRUE(at);
  EXPECT_EQ(at->event, Event::Graze);
  EXPECT_EQ(at->feature, Feature::Kind::Edge);
  EXPECT_EQ(at->moved(0)->ball.radius, 1);
  EXPECT_EQ(at->moved(0.125)->ball.radius, 1.5);
  EXPECT_FALSE(at->moved(-0.5));     // a negative radius
  EXPECT_FALSE(at->moved(0x1p-60));  // the same double
  EXPECT_FALSE(find_threshold(square, {{{2, 2, 4}, 1}, {2, 2, -4}}));
}

/// Returns all results about the changed method.
MethodErrors measured(run_tests::PlantedMethod::MovingChange change, std::uint64_t samples = 2) {
  const run_tests::PlantedMethod method(std::move(change));
  const Settings settings{.methods = {&method}, .vertices = 6, .samples = samples, .seed = 2};
  Errors errors;
  measure_errors(settings, {kNeverStop, kSilent}, errors);
  EXPECT_EQ(errors.samples, samples);
  EXPECT_EQ(errors.disagreements, 0U);
  return errors.sum(0, [](const Kind&) { return true; });
}

TEST(MotionErrors, OfTheTruthAreNone) {
  const MethodErrors errors = measured([](PartialAnswer&, const Motion&) {});
  EXPECT_GT(errors.samples.trials, 40U);
  EXPECT_EQ(errors.samples.wrong, 0U);
  EXPECT_EQ(cases::total(errors.offsets).wrong, 0U);
  EXPECT_FALSE(errors.furthest.any);
  EXPECT_EQ(errors.times.found, errors.times.ways.count());
  EXPECT_LT(errors.times.ulps.count(), errors.times.found);  // contacts at the start
  EXPECT_GT(errors.times.ulps.count(), 0U);
  EXPECT_EQ(errors.times.ulps.largest(), 0);
}

TEST(MotionErrors, TellMissedContactsFromInventedOnes) {
  const MethodErrors missed = measured([](PartialAnswer& answer, const Motion&) { answer.contact = false; });
  const MethodErrors invented = measured([](PartialAnswer& answer, const Motion&) { answer.contact = true; });
  for (std::size_t i = 0; i < all_offsets().size(); ++i) {
    const bool touches = all_offsets()[i] >= 0;
    EXPECT_EQ(missed.offsets[i].wrongly_out, touches ? missed.offsets[i].trials : 0) << i;
    EXPECT_EQ(missed.offsets[i].wrongly_in, 0U) << i;
    EXPECT_EQ(invented.offsets[i].wrongly_in, touches ? 0 : invented.offsets[i].trials) << i;
    EXPECT_EQ(invented.offsets[i].wrongly_out, 0U) << i;
  }
  EXPECT_EQ(missed.samples.wrong, missed.samples.trials);
  EXPECT_EQ(missed.times.found, 0U);
  EXPECT_EQ(missed.furthest.share, 0x1p-4);
}

TEST(MotionErrors, UndecidedAnswersAreNeitherWrongNorCounted) {
  const MethodErrors errors = measured([](PartialAnswer& answer, const Motion&) { answer.contact.reset(); });
  EXPECT_EQ(cases::total(errors.offsets).unsure, cases::total(errors.offsets).trials);
  EXPECT_EQ(errors.samples.wrong, 0U);
  EXPECT_EQ(errors.samples.trials, 0U);
}

TEST(MotionErrors, OfTimesAreUnitsAndWays) {
  const MethodErrors errors = measured([](PartialAnswer& answer, const Motion&) {
    if (answer.time > 0 && answer.contact == true) answer.time = std::nextafter(*answer.time, 0.0);
  });
  EXPECT_GT(errors.times.ulps.count(), errors.times.ulps.zeros());
  EXPECT_GE(errors.times.ulps.largest(), 0.5);
  EXPECT_LE(errors.times.ulps.largest(), 1);
  EXPECT_GT(errors.times.ways.largest(), 0);
  EXPECT_LT(errors.times.ways.largest(), 0x1p-48);
}

// A tolerance is seen as far from the threshold as it reaches, and no further.
TEST(MotionErrors, AToleranceIsFoundWhereItIs) {
  const MethodErrors errors = measured(
      [](PartialAnswer& answer, const Motion& motion) {
        if (answer.contact == false && motion.ball.radius > 0) answer.contact = std::nullopt;
      },
      1);
  for (std::size_t i = 0; i < all_offsets().size(); ++i)
    EXPECT_EQ(errors.offsets[i].unsure > 0, all_offsets()[i] < 0 && errors.offsets[i].trials > 0) << i;
}

TEST(MovingMethods, AreThoseThatAnswer) {
  const auto all = find_moving_methods({{"all"}});
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(all, [name](const cases::Method* method) { return method->name() == name; });
  };
  EXPECT_TRUE(has("exact") && has("filtered") && has("fast") && has("cgal-epeck-distance"));
  EXPECT_FALSE(has("thesis") || has("boost-geometry") || has("ode") || has("embree-fast"));
  EXPECT_THROW((void)find_moving_methods({{"thesis"}}), std::invalid_argument);
  EXPECT_EQ(find_moving_methods({{"fast", "exact"}}).size(), 2U);
}

// An engine of the user that answers every case alike; `verdict`: the keys after the id.
methods::Selection engine(const std::string& name, const std::string& verdict) {
  return {{"fast"}, {R"~(sed -u 's/.*"id":"\([0-9]*\)".*/{"id":"\1")~" + verdict + "}/' =" + name}};
}

TEST(MovingMethods, AreNoEnginesThatIgnoreTheMotion) {
  EXPECT_EQ(find_moving_methods(engine("moves", R"(,"contact":true)")).size(), 2U);
  for (const auto& [name, verdict] : {std::pair("stays", R"(,"contact":false)"), {"silent", ""}}) {
    const methods::Selection ignoring = engine(name, verdict);
    const std::string said =
        run_tests::message_of<std::invalid_argument>([&] { return find_moving_methods(ignoring); });
    EXPECT_NE(said.find("it seems to ignore `motion`"), std::string::npos) << name << ": " << said;
  }
}

TEST(GrazingPass, IsSeenAcrossTheEdge) {
  const auto pass = find_grazing_pass(8, 1);
  ASSERT_TRUE(pass);
  const Motion& motion = pass->at.motion;
  const Eigen::Vector3d center = motion.ball.center + pass->first.time * (motion.to - motion.ball.center);
  EXPECT_NEAR(pass->seen(pass->first.point).norm(), 0, 1e-15);
  EXPECT_NEAR(pass->seen(center).x(), 0, 1e-6);
  EXPECT_NEAR(pass->seen(center).y(), motion.ball.radius / pass->extent, 1e-12);
  EXPECT_NEAR(pass->seen(motion.ball.center).y(), pass->seen(motion.to).y(), 1e-12);
  const auto said = ask_about(*pass, methods::find_methods({"exact", "fast-float"}));
  for (const Said& one : said) {
    EXPECT_EQ(one.truth, one.offset >= 0) << one.offset;
    if (one.method == "exact") {
      EXPECT_EQ(one.contact, one.truth) << one.offset;
    }
  }
}

const std::vector<std::string> kSmallRun{
    "--methods", "filtered,fast-float", "--vertices", "6", "--passes", "60", "--repetitions", "1", "--no-pictures"};

TEST(Motions, TheNumberOfThreadsChangesNothing) {
  std::vector<std::string> three = kSmallRun;
  three.insert(three.end(), {"--samples", "3"});
  run_tests::expect_that_threads_change_nothing(
      commands::motions_command, three,
      {"ways.csv", "thresholds.csv", "furthest.jsonl", "pass.csv", "pass-scene.csv", "steps.csv"});
}

TEST(Motions, AreNotAskedOfAMethodThatKnowsNone) {
  const Scratch scratch;
  const auto ran = run_tests::run_captured(commands::motions_command,
                                           {"--methods", "thesis", "--output", (scratch.path / "none").string()});
  EXPECT_EQ(ran.status, 2);
}

// What is written as wrong is wrong: as a case that the judge takes, with the exact answer.
TEST(Motions, TheFurthestWrongAnswersAreCases) {
  const Scratch scratch;
  std::vector<std::string> arguments = kSmallRun;
  arguments.insert(arguments.end(), {"--samples", "3"});
  std::ifstream lines(run_tests::run_into(scratch.path / "run", commands::motions_command, arguments) /
                      "furthest.jsonl");
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const cases::Case read = cases::read_case(line);
    const auto& shapes = std::get<cases::Shapes>(read.content);
    const Motion motion = *shapes.motion();
    const auto truth = PartialAnswer::of(exact::first_contact(motion, shapes.polygon),
                                         exact::answer(shapes.ball(), shapes.polygon).off_plane, "");
    EXPECT_TRUE(cases::differences(*read.expected, truth).empty()) << line;
    const auto answer = methods::find_method("fast-float")->prepare(shapes.polygon)->ask_moving(motion);
    EXPECT_NE(answer->contact, truth.contact) << line;
  }
  EXPECT_EQ(count, 1);  // filtered has none
}

}  // namespace
}  // namespace touchstone::motions

// SPDX-License-Identifier: GPL-3.0-or-later
// The study of run time and error: what is planted is measured, fronts are fronts, and it keeps its promises.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/workloads/ulp.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/tradeoff/front.h"
#include "robust/exact/exact.h"
#include "tests/experiments/studies/tradeoff/small_study.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/planted_method.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::tradeoff {
namespace {

namespace fs = std::filesystem;
using cases::PartialAnswer;
using cases::QueryKind;
using run_tests::PlantedMethod;
using run_tests::Scratch;
using workloads::Family;
using workloads::Placement;

using run_tests::kNeverStop;
using run_tests::kSilent;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What one method did in all strata of a placement whose threshold is crossed by the radius.
MethodErrors errors_of(const cases::Method& method, Placement placement = Placement::Rotated) {
  const Settings one{{&method}, {Family::Star}, 2, 7, 1};
  return whole(one).sum(strata_of(std::nullopt, placement, true), 0);
}

const UlpErrors& ulps(const MethodErrors& errors, Quantity quantity) {
  return errors.ulps[static_cast<std::size_t>(quantity)];
}

TEST(TradeoffErrors, OfExactAreNone) {
  for (const Placement placement : kPlacements) {
    const MethodErrors errors = errors_of(*methods::find_method("filtered"), placement);
    EXPECT_EQ(errors.samples, 6U);
    EXPECT_EQ(errors.near_threshold(), Answers{{{.trials = errors.near_threshold().trials}}});
    EXPECT_GT(errors.near_threshold().trials, 6 * errors.samples);
    EXPECT_EQ(errors.reach(), 0);
    EXPECT_EQ(to_string(cases::band_of(errors.offsets, &Answers::wrong)), "none seen");
    for (const Quantity quantity : kQuantities) {
      EXPECT_EQ(ulps(errors, quantity).known.count(), errors.samples);
      EXPECT_EQ(ulps(errors, quantity).known.quantile(1), 0);
    }
  }
}

TEST(TradeoffErrors, OfEachThresholdAreOfPolygonsOfItsOwn) {
  const cases::Method& exact = *methods::find_method("exact");
  const auto strata = strata_of(Family::Star, Placement::Planar, true);
  ASSERT_EQ(strata.size(), 3U);
  const auto first = cases::draw_crossing({strata[0], {}, 7, 0}, exact),
             other = cases::draw_crossing({strata[1], {}, 7, 0}, exact);
  EXPECT_NE(first->polygon.vertex(0), other->polygon.vertex(0));
  const Errors errors = whole({{methods::find_method("fast")}, {Family::Star, Family::L}, 2, 7, 1});
  EXPECT_EQ(errors.polygons(strata, 0), 6U);
}

TEST(TradeoffErrors, OfOneUnitAreMeasuredAsOne) {
  const PlantedMethod method([](const auto& exact, const Ball& ball, QueryKind kind) {
    PartialAnswer answer = exact.ask(ball, kind);
    if (kind != QueryKind::Answer) return answer;
    answer.distance = std::nextafter(*answer.distance, kInfinity);
    int axis = 0;
    answer.point->cwiseAbs().maxCoeff(&axis);
    (*answer.point)[axis] = std::nextafter((*answer.point)[axis], (*answer.point)[axis] > 0 ? kInfinity : -kInfinity);
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  for (const Quantity quantity : kQuantities) {
    EXPECT_EQ(ulps(errors, quantity).known.quantile(0), 1);
    EXPECT_EQ(ulps(errors, quantity).known.quantile(1), 1);
    EXPECT_EQ(errors.worst[static_cast<std::size_t>(quantity)].ulps, 1);
  }
}

// A ball that is taken for larger than it is, by 3 u, and polygons about as large as 1: wrong from there to the threshold.
TEST(TradeoffErrors, AreSeenInTheBandWhereTheyWerePlanted) {
  const PlantedMethod method([](const auto& exact, const Ball& ball, QueryKind kind) {
    return exact.ask({ball.center, ball.radius + 0x3p-53}, kind);
  });
  const MethodErrors errors = errors_of(method, Placement::Planar);
  const cases::Band band = cases::band_of(errors.offsets, &Answers::wrong);
  EXPECT_LT(*band.lowest, -0.5);
  EXPECT_GT(*band.lowest, -64);
  EXPECT_LE(*band.highest, 0);
  EXPECT_EQ(errors.reach(), -*band.lowest);
  EXPECT_EQ(errors.near_threshold().unsure, 0U);
}

TEST(TradeoffErrors, CountWhatIsLeftOpenApart) {
  const PlantedMethod method([](const auto&, const Ball&, QueryKind) {
    PartialAnswer answer;
    answer.unsure = true;
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  const Answers near = errors.near_threshold();
  EXPECT_EQ(near.unsure, near.trials);
  EXPECT_EQ(near.wrong, 0U);
  EXPECT_EQ(near.contract, near.trials);
  EXPECT_EQ(ulps(errors, Quantity::Point).known.count(), 0U);
  EXPECT_EQ(ulps(errors, Quantity::Point).asked, errors.samples);
}

// One distance in three is infinite, and all contacts are wrong: a third of them for that reason; the errors of the
// other distances are still told.
TEST(TradeoffErrors, OfWhatIsNotFiniteAreCountedApart) {
  int number = 0;
  const PlantedMethod method([&number](const auto& exact, const Ball& ball, QueryKind kind) {
    PartialAnswer answer = exact.ask(ball, kind);
    if (kind != QueryKind::Answer) {
      if (answer.contact) answer.contact = !*answer.contact;
      return answer;
    }
    answer.distance = number++ % 3 == 0 ? kInfinity : std::nextafter(*answer.distance, kInfinity);
    return answer;
  });
  const MethodErrors errors = errors_of(method);
  ASSERT_EQ(errors.samples, 6U);
  const Answers near = errors.near_threshold();
  EXPECT_EQ(near.contract, near.trials);
  EXPECT_GT(near.overflowed, near.wrong / 6);
  EXPECT_LT(near.overflowed, near.wrong / 2);
  const UlpErrors& distances = ulps(errors, Quantity::Distance);
  EXPECT_EQ(distances.known.count(), 6U);
  EXPECT_EQ(distances.known.infinite(), 2U);
  for (const double share : {0.0, 0.5, 0.99, 1.0}) EXPECT_EQ(distances.quantile_of_finite(share), 1) << share;
  EXPECT_EQ(distances.known.quantile(0.99), kInfinity);
  EXPECT_EQ(ulps(errors, Quantity::Point).quantile_of_finite(1), 0);
}

TEST(TradeoffErrors, SlowMethodsAreAskedAboutFewerSamples) {
  const auto setting = settings({"exact", "fast"}, kSlowStride + 1);
  const Errors errors = whole(setting);
  const auto strata = strata_of(Family::Star, Placement::Rotated, true);
  EXPECT_EQ(errors.sum(strata, 0).samples, strata.size() * 2);
  EXPECT_EQ(errors.sum(strata, 1).samples, strata.size() * (kSlowStride + 1));
}

// The same bytes for one thread and two; the worst cases are legal, expect the truth, and their methods fail them.
TEST(Tradeoff, TheNumberOfThreadsChangesNothing) {
  const Scratch scratch;
  for (const unsigned threads : {1U, 2U}) {
    const auto setting = settings({"fast", "interval", "rational", "thesis"}, 3, threads);
    const auto folder = scratch.path / std::to_string(threads);
    fs::create_directories(folder);
    const Errors errors = whole(setting);
    write_errors(folder, setting, errors);
  }
  for (const char* file : {"errors.csv", "bands.csv", "points.csv", "worst.jsonl"}) {
    EXPECT_EQ(run_tests::text_of(scratch.path / "1" / file), run_tests::text_of(scratch.path / "2" / file)) << file;
    EXPECT_GT(fs::file_size(scratch.path / "1" / file), 1000U) << file;
  }
  std::ifstream lines(scratch.path / "1" / "worst.jsonl");
  int cases = 0;
  for (std::string line; std::getline(lines, line); ++cases) {
    const cases::Case read = cases::read_case(line);
    const auto& shapes = std::get<cases::Shapes>(read.content);
    const auto truth = PartialAnswer::of(exact::answer(shapes.ball(), shapes.polygon), "");
    EXPECT_TRUE(cases::differences(*read.expected, truth).empty()) << *read.id;
    const std::string method = nlohmann::json::parse(line)["tags"][0];
    const auto given = methods::find_method(method)->prepare(shapes.polygon)->ask(shapes.ball(), QueryKind::Answer);
    EXPECT_FALSE(cases::differences(*read.expected, given).empty()) << *read.id;
  }
  EXPECT_EQ(cases, 4);  // of fast, in either placement; the others are right, or say nothing
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::tradeoff_command, std::move(arguments));
}

TEST(TradeoffCommand, WritesResultsAndASidecar) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new";
  ASSERT_EQ(run_command({"--methods", "fast,filtered", "--families", "l,u", "--samples", "1", "--queries", "10",
                         "--repetitions", "1", "--no-pictures", "--output", folder.string()}),
            0);
  for (const char* file : {"errors.csv", "bands.csv", "points.csv", "worst.jsonl", "timings.csv", "front.csv"})
    EXPECT_TRUE(fs::exists(folder / file)) << file;
  const auto record = nlohmann::json::parse(run_tests::text_of(folder / "run.json"));
  EXPECT_EQ(record["interrupted"], false);
  EXPECT_EQ(record["samples_done"], 1);
}

TEST(TradeoffCommand, WrongOptionsAreErrorsThatNameThem) {
  const auto complaint = [](const std::vector<std::string>& arguments) {
    return run_tests::message_of<std::exception>([&] { run_command(arguments); });
  };
  EXPECT_NE(complaint({"--methods", "slow"}).find("\"slow\""), std::string::npos);
  EXPECT_NE(complaint({"--families", "donut"}).find("--families"), std::string::npos);
  EXPECT_NE(complaint({"--queries", "many"}).find("--queries"), std::string::npos);
  EXPECT_NE(complaint({"--repetitions", "0"}).find("--repetitions"), std::string::npos);
  EXPECT_NE(complaint({"--redraw", "--output", "/nowhere"}).find("--redraw"), std::string::npos);
  EXPECT_NE(complaint({"--redraw", "--samples", "5"}).find("--samples excludes --redraw"), std::string::npos);
  EXPECT_NE(complaint({"--redraw", "--no-pictures"}).find("--no-pictures excludes --redraw"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::tradeoff

// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of filtered with fast: how it is measured, and that tables and files hold all of it. No time is
// asserted.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/commands.h"
#include "experiments/program/timing.h"
#include "experiments/studies/bench/families.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::bench {
namespace {

namespace fs = std::filesystem;
using run_tests::Scratch;

using run_tests::kNeverStop;
using run_tests::kSilent;

int run_bench(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::bench_command, std::move(arguments));
}

/// Answers the numbers that it is asked; right about all but those below `wrong`.
timing::Candidate counter(std::string name, std::size_t queries, std::size_t wrong, std::vector<std::string>* log) {
  const auto ask = [name, log](std::size_t count) {
    if (count > 1 && log != nullptr) log->push_back(name);
    return static_cast<std::uint64_t>(count);
  };
  return {name, queries, ask, [wrong](std::size_t count) { return std::min(wrong, count); }, {}, {}};
}

timing::Benchmark duel(std::vector<std::string>* log = nullptr) {
  timing::Benchmark benchmark;
  benchmark.name = "duel";
  benchmark.checked = 10;
  benchmark.candidates = {counter("base", 100, 0, log), counter("other", 100, 3, log)};
  benchmark.candidates[1].comparison = timing::Comparison{"base", timing::Goal{1e9}};
  return benchmark;
}

TEST(BenchMeasurement, QuartilesLieBetweenTheSortedValues) {
  const timing::Quartiles q = timing::quartiles({5, 1, 4, 2, 3});
  EXPECT_EQ(q.minimum, 1);
  EXPECT_EQ(q.lower, 2);
  EXPECT_EQ(q.median, 3);
  EXPECT_EQ(q.upper, 4);
  EXPECT_EQ(q.maximum, 5);
  EXPECT_EQ(timing::quartiles({1, 2}).median, 1.5);
  EXPECT_EQ(timing::quartiles({7}).upper, 7);
}

TEST(BenchMeasurement, CandidatesTakeTurnsAndEachBegins) {
  std::vector<std::string> log;
  EXPECT_EQ(measure("test", duel(&log), 4, kNeverStop, kSilent).candidates.size(), 2U);
  ASSERT_GE(log.size(), 8U);
  const std::vector<std::string> timed(log.end() - 8, log.end());
  EXPECT_EQ(timed, (std::vector<std::string>{"base", "other", "other", "base", "base", "other", "other", "base"}));
}

TEST(BenchMeasurement, HoldsEveryRepetitionRatioAndWrongAnswer) {
  const timing::Result result = measure("test", duel(), 5, kNeverStop, kSilent);
  ASSERT_EQ(result.candidates.size(), 2U);
  const auto& [base, other] = std::tie(result.candidates[0], result.candidates[1]);
  EXPECT_EQ(base.queries, 100U);
  EXPECT_EQ(base.nanoseconds.size(), 5U);
  EXPECT_TRUE(base.ratios.empty());
  ASSERT_EQ(other.ratios.size(), 5U);
  EXPECT_EQ(other.ratios[2], other.nanoseconds[2] / base.nanoseconds[2]);
  EXPECT_EQ(base.wrong->count, 0U);
  EXPECT_EQ(other.wrong->count, 3U);
  EXPECT_EQ(other.wrong->of, 10U);
}

TEST(BenchMeasurement, AComparisonWithNobodyIsRefused) {
  timing::Benchmark benchmark = duel();
  benchmark.candidates[1].comparison->base = "nobody";
  EXPECT_THROW((void)measure("test", benchmark, 1, kNeverStop, kSilent), std::logic_error);
}

TEST(BenchMeasurement, PoolsAreMeans) {
  timing::Result one{"test",
                     "one",
                     "",
                     "query",
                     "all",
                     {{"base", 10, {2, 4}, timing::Wrong{1, 5}, {}, {}},
                      {"other", 10, {2, 2}, {}, timing::Comparison{"base", {}}, {1, 0.5}}}};
  timing::Result two = one;
  two.candidates[0].nanoseconds = {4, 8};
  const auto both = timing::pooled({one, two}, "all");
  ASSERT_TRUE(both);
  EXPECT_EQ(both->name, "all");
  EXPECT_EQ(both->candidates[0].nanoseconds, (std::vector<double>{3, 6}));
  EXPECT_EQ(both->candidates[0].wrong->of, 10U);
  EXPECT_EQ(both->candidates[1].ratios, (std::vector<double>{2 / 3.0, 2 / 6.0}));
  EXPECT_FALSE(timing::pooled({one}, "all"));
  EXPECT_FALSE(timing::pooled({one, two}, "none"));
}

TEST(BenchMeasurement, AStopLeavesWhatWasMeasured) {
  std::atomic<bool> stop = false;
  const timing::Result result = measure("test", duel(), 10, stop, [&](std::uint64_t done) { stop = done == 3; });
  EXPECT_EQ(result.candidates[0].nanoseconds.size(), 3U);
  EXPECT_EQ(result.candidates[1].ratios.size(), 3U);
  EXPECT_FALSE(result.candidates[0].wrong);
}

TEST(BenchOutput, AMissedGoalIsShownAsSuch) {
  timing::Result result{"test",
                        "",
                        "",
                        "query",
                        "",
                        {{"base", 10, {2, 2}, {}, {}, {}},
                         {"other", 10, {6, 6}, {}, timing::Comparison{"base", timing::Goal{2}}, {3, 3}}}};
  EXPECT_NE(timing::table(result).find("<= 2 MISSED"), std::string::npos);
  EXPECT_NE(timing::goals({result}).find("0 of 1 goals met; missed:\n  test: other is 3.00 x base, not <= 2"),
            std::string::npos);
  EXPECT_EQ(timing::json({result})[0]["contestants"][1]["goal"]["met"], false);
  result.candidates[1].comparison->goal = timing::Goal{2, false};
  EXPECT_NE(timing::table(result).find(">= 2 met"), std::string::npos);
  EXPECT_NE(timing::goals({result}).find("1 of 1 goals met\n"), std::string::npos);
}

TEST(BenchOutput, WrongAnswersAreCounted) {
  const timing::Result result = measure("test", duel(), 2, kNeverStop, kSilent);
  EXPECT_NE(timing::table(result).find(" 0 of 10\n"), std::string::npos) << timing::table(result);
  EXPECT_NE(timing::table(result).find(" 3 of 10\n"), std::string::npos) << timing::table(result);
}

TEST(BenchOutput, ANoisyRatioMeetsNoGoalAndMissesNone) {
  timing::Result result{"test",
                        "",
                        "",
                        "query",
                        "",
                        {{"base", 10, {2, 2}, {}, {}, {}},
                         {"other", 10, {2, 6}, {}, timing::Comparison{"base", timing::Goal{9}}, {1, 1, 1, 3, 3}}}};
  EXPECT_NE(timing::table(result).find("too noisy to tell"), std::string::npos);
  EXPECT_NE(timing::goals({result}).find("0 of 1 goals met; too noisy to tell:\n  test: other\n"), std::string::npos);
  const auto other = timing::json({result})[0]["contestants"][1];
  EXPECT_TRUE(other["goal"]["met"].is_null());
  EXPECT_EQ(other["ratio"]["too_noisy"], true);
}

// Every family that is not slow to draw gives rows for all that it promises, and nobody exact errs.
TEST(BenchCommand, PrintsAndWritesEveryRow) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new";
  const std::string families =
      "random-triangles,half-near,near,lattice-tangent,slivers,far,extreme,polygons-8,off-plane,questions,batches";
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_bench({"--family", families, "--samples", "50", "--repetitions", "2", "--seed", "5", "--output",
                       folder.string()}),
            0);
  const std::string text = testing::internal::GetCapturedStdout();
  const auto all = nlohmann::json::parse(std::ifstream(folder / "bench.json"));

  EXPECT_EQ(all["run"]["seed"], 5);
  EXPECT_TRUE(all["run"].contains("flags"));
  EXPECT_TRUE(all["processor_features"].contains("compiled_for"));
  EXPECT_TRUE(fs::exists(folder / "run.json"));
  EXPECT_EQ(all["contests"].size(), 7U + (4 + 1 + 2 + 4) + 3 + 10 + 4);
  for (const auto& benchmark : all["contests"]) {
    const std::string family = benchmark["family"], name = benchmark["name"];
    EXPECT_NE(text.find("\n" + family + (name.empty() ? "" : ", " + name)), std::string::npos);
    EXPECT_GE(benchmark["contestants"].size(), 2U) << family << ", " << name;
    for (const auto& candidate : benchmark["contestants"]) {
      const std::string who = candidate["name"];
      EXPECT_EQ(candidate["nanoseconds"]["repetitions"].size(), 2U);
      if (name != "preparation") {
        EXPECT_GT(candidate["wrong"]["of"], 0) << family << ", " << name << ", " << who;
      }
      if (who.starts_with("filtered") || who.starts_with("EPECK") || family == "off-plane") {
        EXPECT_EQ(candidate.value("/wrong/count"_json_pointer, 0), 0) << family << ", " << name << ", " << who;
      }
      if (who.starts_with("filtered")) {
        EXPECT_EQ(candidate["ratio"]["repetitions"].size(), 2U);
      }
    }
  }
  EXPECT_NE(text.find("goals met"), std::string::npos);
  EXPECT_NE(text.find("Fewer than 100000 samples"), std::string::npos);
}

// The candidates of the families that a test has no time for.
TEST(BenchFamilies, AreAllThere) {
  std::vector<std::string> names;
  for (const Family& family : all_families()) {
    names.push_back(family.name);
    EXPECT_FALSE(family.summary.empty());
    EXPECT_FALSE(family.benchmarks.empty());
  }
  for (const char* name : {"polygons-8", "polygons-32", "polygons-128", "polygons-1024", "polygons-10000",
                           "polygons-100000", "off-plane", "questions", "batches", "nearness"})
    EXPECT_EQ(std::ranges::count(names, name), 1) << name;
}

// The nearer to contact, the more queries need a stage beyond doubles.
TEST(BenchFamilies, NearnessTellsWhichStageDecides) {
  Settings settings;
  settings.samples = 300;
  const auto nearness = std::ranges::find(all_families(), "nearness", &Family::name);
  ASSERT_NE(nearness, all_families().end());
  double before = 0;
  for (const auto& draw : nearness->benchmarks) {
    const timing::Benchmark benchmark = draw(settings);
    double sum = 0;
    for (const timing::Share& part : benchmark.shares) sum += part.share;
    EXPECT_NEAR(sum, 1, 1e-9) << benchmark.name;
    ASSERT_EQ(benchmark.shares.front().name, "double");
    EXPECT_GE(benchmark.shares.front().share, before) << benchmark.name;
    before = benchmark.shares.front().share;
    for (const timing::Candidate& candidate : benchmark.candidates) {
      if (candidate.name == "filtered" || candidate.name == "EPECK") {
        EXPECT_EQ(candidate.count_wrong(300), 0U) << benchmark.name << ", " << candidate.name;
      }
    }
  }
  EXPECT_NEAR(before, 1, 1e-9);
}

// Without floats a set answers as with them. Balls near all surfaces leave triangles to both ways; the last set has 3.
TEST(BenchFamilies, SetsWithoutFloatsAnswerAsExactDoes) {
  Settings settings;
  settings.samples = 1027;
  const auto batches = std::ranges::find(all_families(), "batches", &Family::name);
  ASSERT_NE(batches, all_families().end());
  for (const std::size_t i : {0U, 1U}) {
    const timing::Benchmark benchmark = batches->benchmarks[i](settings);
    const auto without = std::ranges::find(benchmark.candidates, "filtered, no floats", &timing::Candidate::name);
    ASSERT_NE(without, benchmark.candidates.end()) << benchmark.name;
    EXPECT_EQ(without->comparison->base, "filtered, set");
    EXPECT_EQ(without->count_wrong(settings.samples), 0U) << benchmark.name;
    if (i == 1) {
      EXPECT_GT(without->ask(settings.samples), 100U);
      EXPECT_LT(without->ask(settings.samples), 927U);
    }
  }
}

// Goals are part of what is measured.
TEST(BenchFamilies, KnowTheirGoals) {
  const auto goal = [](const std::string& family, const std::string& candidate) {
    Settings settings;
    settings.samples = 1;
    settings.checks = false;
    const auto found = std::ranges::find(all_families(), family, &Family::name);
    for (const timing::Candidate& c : found->benchmarks.front()(settings).candidates)
      if (c.name == candidate && c.comparison && c.comparison->goal) return c.comparison->goal->ratio;
    return 0.0;
  };
  EXPECT_EQ(goal("random-triangles", "filtered"), 1);
  EXPECT_EQ(goal("random-triangles", "EPECK"), 100);
  EXPECT_EQ(goal("half-near", "filtered"), 2.5);
  EXPECT_EQ(goal("near", "filtered"), 4);
  EXPECT_EQ(goal("extreme", "filtered"), 10);
  EXPECT_EQ(goal("half-near", "EPECK"), 50);
  EXPECT_EQ(goal("lattice-tangent", "filtered"), 10);
  EXPECT_EQ(goal("slivers", "filtered"), 0);
  EXPECT_EQ(goal("polygons-128", "filtered"), 0.25);
  EXPECT_EQ(goal("polygons-1024", "filtered"), 0.08);
  EXPECT_EQ(goal("polygons-100000", "filtered"), 0.001);
}

TEST(BenchCommand, CountsAsksOneCandidateOnly) {
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_bench({"--family", "random-triangles", "--count", "fast", "--samples", "30", "--repetitions", "3"}), 0);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(text.rfind("random-triangles, fast: 30 queries, 3 times; sum of the answers ", 0), 0U) << text;
}

// Four outlines are asked about prepared polygons. The queries that prepare a polygon each would hide their cost.
TEST(BenchCommand, CountsTheQueriesOfOnePool) {
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_bench({"--family", "polygons-8", "--count", "fast", "--samples", "30", "--repetitions", "1"}), 0);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(text.rfind("polygons-8, fast: 120 queries, 1 times; ", 0), 0U) << text;
}

TEST(BenchCommand, WrongOptionsAreErrors) {
  const Scratch scratch;
  std::ofstream(scratch.path / "not ours") << "kept";
  EXPECT_THROW(run_bench({"--samples", "0"}), program::UsageError);
  EXPECT_THROW(run_bench({"--samples", "10000001"}), program::UsageError);
  EXPECT_THROW(run_bench({"--repetitions", "0"}), program::UsageError);
  EXPECT_THROW(run_bench({"--count", "fast"}), program::UsageError);
  EXPECT_THROW(run_bench({"--family", "far", "--count", "slow", "--samples", "1"}), program::UsageError);
  EXPECT_THROW(run_bench({"--family", "far", "--samples", "1", "--output", scratch.path.string()}), std::runtime_error);
  const std::string said = run_tests::message_of<program::UsageError>([] { run_bench({"--family", "circles"}); });
  EXPECT_NE(said.find("there are random-triangles, half-near, "), std::string::npos) << said;
}

}  // namespace
}  // namespace touchstone::bench

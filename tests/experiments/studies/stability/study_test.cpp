// SPDX-License-Identifier: GPL-3.0-or-later
// The study of stress: that it finds planted errors, that filtered holds at every level, and that it keeps its promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/cases/verdict.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/stability/measure.h"
#include "experiments/studies/stability/onset.h"
#include "tests/experiments/support/planted_method.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::stability {
namespace {

namespace fs = std::filesystem;
using cases::PartialAnswer;
using cases::QueryKind;
using run_tests::Scratch;
using run_tests::text_of;
using Tested = cases::Test;  // within TEST, Test is GoogleTest's

using run_tests::kNeverStop;
using run_tests::kSilent;

Settings settings(const std::vector<std::string>& methods, std::vector<Axis> axes, std::uint64_t samples) {
  return {methods::find_methods(methods), std::move(axes), samples, 5, 1};
}

Summary whole(const Settings& settings) {
  Summary summary;
  run_study(settings, {kNeverStop, kSilent}, summary);
  return summary;
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::stability_command, std::move(arguments));
}

fs::path run_into(const fs::path& folder, std::vector<std::string> arguments) {
  arguments.emplace_back("--no-pictures");
  return run_tests::run_into(folder, commands::stability_command, std::move(arguments));
}

/// `filtered`, with this change of its answers.
run_tests::PlantedMethod planted(std::function<PartialAnswer(PartialAnswer, QueryKind)> change) {
  return run_tests::PlantedMethod(
      [change = std::move(change)](const auto& right, const Ball& ball, QueryKind kind) {
        return change(right.ask(ball, kind), kind);
      },
      "filtered");
}

/// The failures of one method with that test, over levels and nearness.
SampledFailures sum_of(const Summary& summary, Tested test, std::size_t method) {
  SampledFailures sum;
  for (const auto& [cell, failures] : summary.failures)
    if (std::get<2>(cell) == test && std::get<3>(cell) == method) program::add(sum, failures);
  return sum;
}

// Every axis, every level that is not slow, all tests, the numbers too; the accumulated end of a chain included.
TEST(StabilityStudy, FilteredNeverDiffersFromExact) {
  std::vector<Axis> axes;
  for (const Axis axis : all_axes())
    if (!against_motion(axis)) axes.push_back(axis);
  const auto setting = settings({"filtered", "exact"}, axes, 5);
  const Summary summary = whole(setting);
  EXPECT_EQ(summary.missing, 0U);
  EXPECT_EQ(summary.disputed, 0U);
  EXPECT_TRUE(summary.worst.empty());
  std::uint64_t asked = 0, numbers = 0;
  for (const auto& [cell, failures] : summary.failures) {
    const auto& [axis, nearness, test, method, level] = cell;
    EXPECT_EQ(failures.answers.wrong, 0U)
        << to_string(axis) << " " << levels(axis)[level].name << " " << to_string(test);
    asked += failures.answers.trials;
  }
  for (const auto& [cell, errors] : summary.errors) {
    const auto& [axis, quantity, method, level] = cell;
    EXPECT_EQ(errors.largest(), 0) << to_string(axis) << " " << levels(axis)[level].name << " " << to_string(quantity);
    numbers += errors.count();
  }
  EXPECT_GT(asked, 10'000U);
  EXPECT_GT(numbers, 2'000U);
}

// What the chain has done shows in exact itself, and alike in filtered: near thresholds it changes answers, the
// distance moves, and more so after more steps.
TEST(StabilityStudy, AMotionIsNotWhatWasMeant) {
  for (const Axis axis : {Axis::ChainMotion, Axis::PoseMotion}) {
    const auto setting = settings({"exact", "filtered"}, {axis}, 4);
    const Summary summary = whole(setting);
    const cases::Failures near = summary.at(axis, Nearness::OneDouble, Tested::Contact, 0, 3)->samples;
    EXPECT_GT(near.wrong, 0U);
    for (const Nearness nearness : kNearnesses)
      for (std::size_t level = 0; level < 5; ++level) {
        const SampledFailures *exact = summary.at(axis, nearness, Tested::Contact, 0, level),
                              *filtered = summary.at(axis, nearness, Tested::Contact, 1, level);
        EXPECT_EQ(exact->answers.wrong, filtered->answers.wrong);
        if (nearness == Nearness::Ample) {
          EXPECT_EQ(exact->answers.wrong, 0U);
        }
      }
    const auto median = [&](std::size_t level) {
      return summary.errors.at({axis, Quantity::Distance, 0, level}).quantile(0.5);
    };
    EXPECT_GT(median(4), 20 * median(1));
    EXPECT_LT(median(4), 1e-11);
  }
}

TEST(StabilityStudy, FindsPlantedErrors) {
  const auto swapped = planted([](PartialAnswer answer, QueryKind) {
    if (answer.contact) answer.contact = !*answer.contact;
    return answer;
  });
  const auto no_boundary = planted([](PartialAnswer answer, QueryKind) {
    if (answer.foot == PointLocation::Boundary) answer.foot = PointLocation::Inside;
    return answer;
  });
  const auto throwing = planted([](PartialAnswer answer, QueryKind kind) {
    if (kind == QueryKind::Relation) throw std::runtime_error("no relations, please");
    return answer;
  });
  const auto silent = planted([](PartialAnswer answer, QueryKind) {
    answer.edges_hit.reset();
    return answer;
  });
  const auto long_distance = planted([](PartialAnswer answer, QueryKind) {
    if (answer.distance) *answer.distance *= 1 + 0x1p-40;
    return answer;
  });
  Settings setting{{&swapped, &no_boundary, &throwing, &silent, &long_distance}, {Axis::OffPlane}, 3, 5, 1};
  const Summary summary = whole(setting);

  const SampledFailures all = sum_of(summary, Tested::Contact, 0);
  EXPECT_GT(all.answers.trials, 100U);
  EXPECT_EQ(all.answers.wrong, all.answers.trials);
  EXPECT_EQ(all.samples.wrong, all.samples.trials);
  EXPECT_EQ(sum_of(summary, Tested::Plane, 0).answers.wrong, 0U);
  EXPECT_EQ(sum_of(summary, Tested::Foot, 1).answers.wrong, 0U) << "a method without the word is right on a boundary";
  const cases::Failures relations = sum_of(summary, Tested::Relation, 2).answers;
  EXPECT_EQ(relations.wrong, relations.trials);
  EXPECT_EQ(sum_of(summary, Tested::Contact, 2).answers.wrong, 0U);
  EXPECT_EQ(sum_of(summary, Tested::Edges, 3).answers.trials, 0U);
  for (std::size_t level = 0; level < levels(Axis::OffPlane).size(); ++level) {
    EXPECT_NEAR(summary.errors.at({Axis::OffPlane, Quantity::Distance, 4, level}).quantile(0.5) / 0x1p-40, 1, 1.0 / 64);
    EXPECT_EQ(summary.errors.at({Axis::OffPlane, Quantity::Distance, 0, level}).largest(), 0);
  }
  EXPECT_EQ(summary.first_failure(Axis::OffPlane, Nearness::Ample, Tested::Contact, 0), 0U);
  EXPECT_EQ(summary.first_failure(Axis::OffPlane, Nearness::Ample, Tested::Contact, 1), std::nullopt);
}

// A method finds the mode that its level names, and the study leaves none behind.
TEST(StabilityStudy, AsksInTheModeOfTheLevel) {
  std::set<int> seen;
  const auto watching = planted([&](PartialAnswer answer, QueryKind) {
    seen.insert(std::fegetround());
    return answer;
  });
  Settings setting{{&watching}, {Axis::Rounding}, 1, 5, 1};
  const Summary summary = whole(setting);
  EXPECT_EQ(seen, (std::set<int>{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}));
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  EXPECT_EQ(sum_of(summary, Tested::Contact, 0).answers.wrong, 0U);
}

// Published figures, found again: see Onset.
TEST(StabilityOnset, WrongSignsBeginWhereTheyAreKnownTo) {
  const auto found = methods::find_methods(std::vector<std::string>{"fast", "thesis", "filtered"});
  const std::uint64_t triangles = 4 * TOUCHSTONE_SAMPLES;
  Onset onset(found);
  find_onset(found, triangles, 3, 1, {kNeverStop, kSilent}, onset);
  ASSERT_EQ(onset.methods(), (std::vector<std::string>{"ericson-absolute", "ericson", "fast", "thesis", "filtered"}));
  EXPECT_EQ(onset.triangles(), triangles);
  constexpr std::size_t kAbsolute = 0, kEricson = 1, kFast = 2, kThesis = 3, kFiltered = 4;
  for (const std::size_t method : {kAbsolute, kEricson, kFast, kThesis}) {
    const int first = onset.first(0, method).value();  // about 2^-51 at zero
    EXPECT_GE(first, 46) << onset.methods()[method];
    EXPECT_LE(first, 52) << onset.methods()[method];
  }
  // 1e6 is 2^20: absolute coordinates lose twenty bits, differences none.
  for (const std::size_t method : {kAbsolute, kThesis}) {
    EXPECT_GE(onset.first(1, method).value(), 24) << onset.methods()[method];
    EXPECT_LE(onset.first(1, method).value(), 34) << onset.methods()[method];
    EXPECT_GT(2 * onset.failures(1, method, 36), triangles) << onset.methods()[method];
  }
  // The known 2^-36 is where two of five naive answers are wrong, not where the first is.
  EXPECT_NEAR(onset.first(0, kAbsolute).value() - onset.first(1, kAbsolute).value(), 20, 3);
  EXPECT_NEAR(static_cast<double>(onset.wrong(1, kAbsolute, 36)) / static_cast<double>(2 * triangles), 0.38, 0.08);
  for (std::size_t method = 0; method < onset.methods().size(); ++method)
    for (int k = kCoarsest; k <= kFinest; ++k) {
      EXPECT_GE(onset.wrong(1, method, k), onset.failures(1, method, k));
      EXPECT_LE(onset.wrong(1, method, k), 2 * onset.failures(1, method, k));
    }
  EXPECT_EQ(onset.failures(1, kEricson, 36), 0U);
  EXPECT_EQ(onset.failures(1, kFast, 36), 0U);
  for (std::size_t distance = 0; distance < 2; ++distance) EXPECT_EQ(onset.first(distance, kFiltered), std::nullopt);
}

// As cases for the judge: right by exact, wrong by the method in the first tag.
TEST(StabilityWorst, AreCasesOnWhichTheMethodErrs) {
  const auto setting = settings({"fast", "fast-float", "thesis", "filtered"}, all_axes(), 3);
  const Summary summary = whole(setting);
  for (const auto& [place, worst] : summary.worst) {
    const cases::Case read = cases::read_case(worst.line);
    ASSERT_TRUE(std::holds_alternative<cases::Shapes>(read.content)) << worst.line;
    const auto& shapes = std::get<cases::Shapes>(read.content);
    const auto differences = [&](std::string_view name) {
      const auto prepared = methods::find_method(name)->prepare(shapes.polygon);
      return cases::differences(*read.expected, prepared->ask(shapes.ball(), QueryKind::Answer));
    };
    const std::string name = nlohmann::json::parse(worst.line)["tags"][0];
    EXPECT_TRUE(differences("exact").empty()) << worst.line;
    EXPECT_FALSE(differences(name).empty()) << worst.line;
    EXPECT_NE(name, "filtered");
  }
  EXPECT_GT(summary.worst.size(), 30U);
}

// A method that errs about the final answer anywhere is shown with such a case, though other tests fail further from
// the boundary; in the file such cases come first, those further from the boundary before others.
TEST(StabilityWorst, AreRankedByTheFinalAnswer) {
  const std::vector<Axis> axes{Axis::Aspect, Axis::Parallel, Axis::Origin, Axis::OffPlane};
  const auto setting = settings({"fast", "thesis", "thesis-signed"}, axes, 3);
  const Summary summary = whole(setting);
  std::uint64_t ranked = 0;
  for (const Axis axis : axes)
    for (std::size_t m = 0; m < setting.methods.size(); ++m) {
      int furthest = 0;
      for (const auto& [cell, failures] : summary.failures) {
        const auto& [of_axis, nearness, test, method, level] = cell;
        if (of_axis == axis && method == m && test == Tested::Contact && failures.answers.wrong > 0)
          furthest = std::max(furthest, 1 + static_cast<int>(nearness));
      }
      const auto worst = summary.worst.find({axis, m});
      EXPECT_EQ(worst == summary.worst.end() ? 0 : worst->second.rank, furthest)
          << to_string(axis) << " " << setting.methods[m]->name();
      ranked += furthest > 0 ? 1 : 0;
    }
  EXPECT_GT(ranked, 8U);

  const Scratch scratch;
  const auto folder = run_into(scratch.path, {"--methods", "fast,thesis,thesis-signed", "--axes",
                                              "aspect,parallel,origin,off-plane", "--samples", "3", "--seed", "5"});
  std::ifstream lines(folder / "worst.jsonl");
  std::uint64_t wrong = 0;
  bool others = false;
  for (std::string line; std::getline(lines, line);) {
    const auto read = nlohmann::json::parse(line);
    const bool final_answer = read["expected"].contains("contact");
    EXPECT_EQ(read["tags"][2], final_answer ? "wrong final answer" : "right final answer");
    EXPECT_FALSE(final_answer && others) << line;
    wrong += final_answer ? 1 : 0;
    others = others || !final_answer;
  }
  EXPECT_EQ(wrong, ranked);
}

// A level without failures is told with its number of samples and the limit of their rate.
TEST(StabilityFirstFailure, TellsHowMuchNoneSeenBeforeMeans) {
  const Scratch scratch;
  const auto& all = levels(Axis::Origin);
  const auto folder = run_into(
      scratch.path, {"--methods", "thesis-signed,filtered", "--axes", "origin", "--samples", "4", "--seed", "5"});
  const auto number = [](const Level& level) { return nlohmann::json::parse(level.name); };
  int none = 0, failed = 0;
  for (const auto& row : run_tests::rows_of(folder / "first-failure.csv")) {
    if (row["method"] == "filtered") {
      ++none;
      EXPECT_TRUE(row["first_failure"].is_null()) << row;
      EXPECT_EQ(row["level_before"], number(all.back()));
    }
    const auto first = std::ranges::find(all, row["first_failure"], number);
    if (first == all.begin()) {
      EXPECT_TRUE(row["level_before"].is_null()) << row;
    } else if (first != all.end()) {
      EXPECT_EQ(row["level_before"], number(*std::prev(first)));
      ++failed;
    }
    if (row["level_before"].is_null()) continue;
    EXPECT_EQ(row["samples_before"], 4);
    EXPECT_NEAR(row["upper_before"].get<double>(), 1 - std::pow(0.025, 0.25), 1e-6);
  }
  EXPECT_GT(none, 0);
  EXPECT_GT(failed, 0);
}

TEST(StabilityCommand, TheNumberOfThreadsChangesNothing) {
  run_tests::expect_that_threads_change_nothing(
      commands::stability_command,
      {"--methods", "fast,thesis", "--axes", "aspect,parallel,chain-motion,flush", "--samples", "6", "--no-pictures"},
      {"failures.csv", "first-failure.csv", "errors.csv", "worst.jsonl", "onset.csv"});
}

// What one axis gives does not depend on which others, and which methods, are asked for.
TEST(StabilityStudy, AxesAndMethodsStandAlone) {
  const auto alone = settings({"fast"}, {Axis::Origin}, 3),
             among = settings({"thesis", "fast"}, {Axis::Aspect, Axis::Origin}, 3);
  const Summary one = whole(alone), two = whole(among);
  std::uint64_t compared = 0;
  for (const auto& [cell, failures] : one.failures) {
    const auto [axis, nearness, test, method, level] = cell;
    const SampledFailures* other = two.at(axis, nearness, test, 1, level);
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(failures.answers, other->answers);
    ++compared;
  }
  EXPECT_GT(compared, 50U);
}

TEST(StabilityCommand, WritesResultsAndASidecar) {
  const Scratch scratch;
  const auto folder = scratch.path / "it's new" / "too";
  ASSERT_EQ(run_command({"--methods", "fast", "--axes", "origin,aspect,origin", "--samples", "1", "--seed", "5",
                         "--no-pictures", "--output", folder.string()}),
            0);
  const auto record = nlohmann::json::parse(text_of(folder / "run.json"));
  EXPECT_EQ(record["seed"], 5);
  EXPECT_EQ(record["samples_done"], 1);
  for (const char* file : {"failures.csv", "first-failure.csv", "errors.csv", "worst.jsonl", "onset.csv"})
    EXPECT_GT(fs::file_size(folder / file), 50U) << file;
}

TEST(StabilityCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_command({"--methods", "slow"}), std::invalid_argument);
  EXPECT_THROW(run_command({"--axes", "width"}), program::UsageError);
}

}  // namespace
}  // namespace touchstone::stability

// SPDX-License-Identifier: GPL-3.0-or-later
// The study of stress: that it finds planted errors, that filtered and the bounds hold at every level, and that it
// keeps its promises.
#include <gtest/gtest.h>

#include <cfenv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "experiments/cases/verdict.h"
#include "experiments/commands.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/stability/summary.h"
#include "tests/experiments/studies/stability/small_study.h"
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
    if (std::get<2>(cell) == test && std::get<3>(cell) == method) run::add(sum, failures);
  return sum;
}

// Every axis, every level that is not slow, all tests, the numbers too; the accumulated end of a chain included.
TEST(StabilityStudy, FilteredNeverDiffersFromExact) {
  std::vector<Axis> axes;
  for (const Axis axis : all_axes())
    if (!against_motion(axis)) axes.push_back(axis);
  const auto setting = settings({"filtered", "exact"}, axes, 5);
  std::uint64_t asked = 0, numbers = 0;
  for (std::uint64_t number = 0; number < block_count(setting); ++number) {
    const Block block = ask_block(setting, number);
    EXPECT_EQ(block.missing, 0U) << to_string(block.axis);
    EXPECT_EQ(block.disputed, 0U) << to_string(block.axis);
    EXPECT_TRUE(block.worst.empty());
    for (const TestResult& test : block.tests) {
      EXPECT_EQ(test.wrong, 0U) << to_string(block.axis) << " " << levels(block.axis)[test.level].name << " sample "
                                << block.sample << " " << to_string(test.test);
      asked += test.asked;
    }
    for (const NumberError& error : block.errors) {
      EXPECT_EQ(error.relative, 0) << to_string(block.axis) << " " << levels(block.axis)[error.level].name << " sample "
                                   << block.sample << " " << to_string(error.quantity);
      ++numbers;
    }
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
    const cases::Failures near = summary.at(0, Nearness::OneDouble, Tested::Contact, 0, 3)->samples;
    EXPECT_GT(near.wrong, 0U);
    for (const Nearness nearness : kNearnesses)
      for (std::size_t level = 0; level < 5; ++level) {
        const SampledFailures *exact = summary.at(0, nearness, Tested::Contact, 0, level),
                              *filtered = summary.at(0, nearness, Tested::Contact, 1, level);
        EXPECT_EQ(exact->answers.wrong, filtered->answers.wrong);
        if (nearness == Nearness::Ample) {
          EXPECT_EQ(exact->answers.wrong, 0U);
        }
      }
    const auto median = [&](std::size_t level) {
      return summary.errors.at({0, Quantity::Distance, 0, level}).quantile(0.5);
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
    EXPECT_NEAR(summary.errors.at({0, Quantity::Distance, 4, level}).quantile(0.5) / 0x1p-40, 1, 1.0 / 64);
    EXPECT_EQ(summary.errors.at({0, Quantity::Distance, 0, level}).largest(), 0);
  }
  EXPECT_EQ(summary.first_level(setting, 0, Nearness::Ample, Tested::Contact, 0, 0.5), 0U);
  EXPECT_EQ(summary.first_level(setting, 0, Nearness::Ample, Tested::Contact, 1, 0), std::nullopt);
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

// All bounds hold on all axes; were they a thousandth, the study would see it of every quantity.
TEST(StabilityBounds, HoldAndWouldBeFoundWrong) {
  auto setting = settings({}, all_axes(), 5);
  const Summary right = whole(setting);
  std::uint64_t observations = 0;
  ASSERT_EQ(right.all_bounds.size(), bounded_quantities().size());
  for (const auto& [quantity, bound] : right.all_bounds) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    EXPECT_GT(bound.polygons, 20U) << about.name;
    observations += bound.tightness.count();
    if (about.stage == BoundStage::FastPlanarity) continue;  // not proved
    EXPECT_EQ(bound.exceeded, 0U) << to_string(about.stage) << " " << about.name;
    EXPECT_LE(bound.tightness.largest(), 1) << to_string(about.stage) << " " << about.name;
    EXPECT_GE(bound.tightness.quantile(0), 0) << "errors to either side count: " << about.name;
  }
  EXPECT_GT(observations, 20'000U);
  // Levels of which fewer samples are drawn have their share. (Beyond its window, at extreme exponents, no bound is
  // used.)
  for (std::size_t axis = 0; axis < all_axes().size(); ++axis)
    for (std::size_t level = 0; level < levels(all_axes()[axis]).size(); ++level) {
      const Axis about = all_axes()[axis];
      const bool extreme = about == Axis::Small || about == Axis::Large || about == Axis::Mixed;
      if (levels(about)[level].one_in > 4 || against_motion(about) || extreme) continue;
      const auto at_level = [&](const auto& cell) {
        return std::get<1>(cell.first) == axis && std::get<2>(cell.first) == level;
      };
      EXPECT_TRUE(std::any_of(right.bounds.begin(), right.bounds.end(), at_level))
          << to_string(about) << " " << levels(about)[level].name;
    }

  setting.bound_factor = 1.0 / 1000;
  const Summary wrong = whole(setting);
  for (const auto& [quantity, bound] : wrong.all_bounds) {
    const BoundedQuantity& about = bounded_quantities()[quantity];
    EXPECT_GT(bound.exceeded, 0U) << to_string(about.stage) << " " << about.name;
    EXPECT_GT(bound.failed, 0U);
    EXPECT_GT(bound.tightness.largest(), 1);
  }
}

// In the pictures the bound is a line: constant times condition, where nothing underflows.
TEST(StabilityBounds, AreTheirConstantTimesTheCondition) {
  const auto setting = settings({}, {Axis::Aspect, Axis::Origin, Axis::Rounding}, 5);
  std::uint64_t compared = 0;
  for (std::uint64_t number = 0; number < block_count(setting); ++number)
    for (const auto& [level, o] : ask_block(setting, number).bounds) {
      if (!(o.relative_error > 0) || !(o.tightness > 0)) continue;
      const double line = bounded_quantities()[o.quantity].constant * o.condition;
      EXPECT_NEAR(o.relative_error / o.tightness / line, 1, 1e-6) << bounded_quantities()[o.quantity].name;
      ++compared;
    }
  EXPECT_GT(compared, 1000U);
}

void write_all(const fs::path& folder, const Settings& setting) {
  fs::create_directories(folder);
  const Summary summary = whole(setting);
  const Known known{onset_of({"fast", "thesis"}, 20, setting.threads), count_contractions(20, setting.seed)};
  write_failures(folder, setting, summary);
  write_errors(folder, setting, summary);
  write_bounds(folder, setting, summary);
  write_worst(folder, summary);
  write_known(folder, known);
  std::ofstream(folder / "table.txt") << table(setting, summary, known);
}

TEST(StabilityStudy, TheNumberOfThreadsChangesNothing) {
  const Scratch scratch;
  for (const unsigned threads : {1U, 2U})
    write_all(scratch.path / std::to_string(threads),
              settings({"fast", "thesis"}, {Axis::Aspect, Axis::Parallel, Axis::ChainMotion, Axis::Flush}, 6, threads));
  int files = 0;
  for (const auto& file : fs::directory_iterator(scratch.path / "1")) {
    EXPECT_EQ(text_of(file.path()), text_of(scratch.path / "2" / file.path().filename())) << file.path();
    ++files;
  }
  EXPECT_EQ(files, 9);
}

// What one axis gives does not depend on which others, and which methods, are asked for.
TEST(StabilityStudy, AxesAndMethodsStandAlone) {
  const auto alone = settings({"fast"}, {Axis::Origin}, 3),
             among = settings({"thesis", "fast"}, {Axis::Aspect, Axis::Origin}, 3);
  const Summary one = whole(alone), two = whole(among);
  std::uint64_t compared = 0;
  for (const auto& [cell, failures] : one.failures) {
    const auto [axis, nearness, test, method, level] = cell;
    const SampledFailures* other = two.at(1, nearness, test, 1, level);
    ASSERT_NE(other, nullptr);
    EXPECT_EQ(failures.answers, other->answers);
    ++compared;
  }
  EXPECT_GT(compared, 50U);
}

int run_command(std::vector<std::string> arguments) {
  return run_tests::run_command(commands::stability_command, std::move(arguments));
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
  for (const char* file : {"failures.csv", "first-failure.csv", "errors.csv", "tightness.csv", "conditions.csv",
                           "worst.jsonl", "onset.csv", "contraction.csv"})
    EXPECT_GT(fs::file_size(folder / file), 50U) << file;
}

TEST(StabilityCommand, WrongOptionsAreErrors) {
  EXPECT_THROW(run_command({"--methods", "slow"}), std::invalid_argument);
  EXPECT_THROW(run_command({"--axes", "width"}), run::UsageError);
}

}  // namespace
}  // namespace touchstone::stability

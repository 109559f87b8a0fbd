// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of the study: worst cases, first failures, tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/cases/case.h"
#include "experiments/cases/comparison.h"
#include "experiments/methods/registry.h"
#include "experiments/studies/stability/summary.h"
#include "tests/experiments/studies/stability/small_study.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::stability {
namespace {

using run_tests::Scratch;

// As cases for the judge: right by exact, wrong by the method in the first tag.
TEST(StabilityWorst, AreCasesOnWhichTheMethodErrs) {
  const auto setting = settings({"fast", "fast-float", "thesis", "filtered"}, all_axes(), 3);
  const Summary summary = whole(setting);
  std::uint64_t found = 0;
  for (const auto& methods : summary.worst)
    for (const auto& worst : methods) {
      if (!worst) continue;
      ++found;
      const cases::Case read = cases::read_case(worst->line);
      ASSERT_TRUE(std::holds_alternative<cases::Shapes>(read.content)) << worst->line;
      const auto& shapes = std::get<cases::Shapes>(read.content);
      const auto differences = [&](std::string_view name) {
        const auto prepared = methods::find_method(name)->prepare(shapes.polygon);
        return cases::differences(*read.expected, prepared->ask(shapes.ball(), cases::QueryKind::Answer));
      };
      const std::string name = nlohmann::json::parse(worst->line)["tags"][0];
      EXPECT_TRUE(differences("exact").empty()) << worst->line;
      EXPECT_FALSE(differences(name).empty()) << worst->line;
      EXPECT_NE(name, "filtered");
    }
  EXPECT_GT(found, 30U);
}

// A method that errs about the final answer anywhere is shown with such a case, though other tests fail further from
// the boundary; in the file such cases come first, those further from the boundary before others.
TEST(StabilityWorst, AreRankedByTheFinalAnswer) {
  const std::vector<Axis> axes{Axis::Aspect, Axis::Parallel, Axis::Origin, Axis::OffPlane};
  const auto setting = settings({"fast", "thesis", "thesis-signed"}, axes, 3);
  const Summary summary = whole(setting);
  std::uint64_t ranked = 0;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    for (std::size_t m = 0; m < setting.methods.size(); ++m) {
      int furthest = 0;
      for (const auto& [cell, failures] : summary.failures) {
        const auto& [of_axis, nearness, test, method, level] = cell;
        if (of_axis == axis && method == m && test == cases::Test::Contact && failures.answers.wrong > 0)
          furthest = std::max(furthest, 1 + static_cast<int>(nearness));
      }
      const auto& worst = summary.worst[axis][m];
      EXPECT_EQ(worst ? worst->rank : 0, furthest) << to_string(axes[axis]) << " " << setting.methods[m]->name();
      ranked += furthest > 0 ? 1 : 0;
    }
  EXPECT_GT(ranked, 8U);

  const Scratch scratch;
  write_worst(scratch.path, summary);
  std::ifstream lines(scratch.path / "worst.jsonl");
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
  const auto setting = settings({"thesis-signed", "filtered"}, {Axis::Origin}, 4);
  const auto& all = levels(Axis::Origin);
  write_failures(scratch.path, setting, whole(setting));
  const auto number = [](const Level& level) { return nlohmann::json::parse(level.name); };
  int none = 0, failed = 0;
  for (const auto& row : run_tests::rows_of(scratch.path / "first-failure.csv")) {
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

// Two axes are modes; each has scenes of its own, and a table of its own.
TEST(StabilityTable, KeepsScenesOfDifferentModesApart) {
  const auto setting = settings({"fast"}, {Axis::Rounding, Axis::Flush}, 2);
  const std::string text = table(setting, whole(setting), {onset_of({}, 0, 1), {}});
  const auto rounding = text.find("Rounding directions"), down = text.find("down "),
             flush = text.find("Subnormals flushed"), daz = text.find("DAZ ");
  EXPECT_LT(rounding, down);
  EXPECT_LT(down, flush);
  EXPECT_LT(flush, daz);
  EXPECT_NE(text.find("the same 2 polygons, with subnormal"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::stability

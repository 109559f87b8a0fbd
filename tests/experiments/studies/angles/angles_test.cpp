// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "experiments/commands.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::angles {
namespace {

using run_tests::rows_of;
using run_tests::Scratch;

/// Runs the study with these arguments. Returns its rows.
nlohmann::json rows_with(const std::vector<std::string>& arguments) {
  const Scratch scratch;
  return rows_of(run_tests::run_into(scratch.path / "run", commands::angles_command, arguments) / "angles.csv");
}

TEST(Angles, AMethodThatIsExactIsNeverWrongAndFloatsAreEverywhere) {
  std::map<std::string, std::set<int>> angles;  // by method
  for (const auto& row : rows_with({"--methods", "filtered,fast-float", "--families", "star,u", "--samples", "12"})) {
    angles[row["method"]].insert(row["angle_deg"].get<int>());
    if (row["method"] == "filtered") {
      EXPECT_EQ(row["failed_samples"], 0) << row;
      EXPECT_GE(row["samples"], 12) << row;
      EXPECT_LE(row["samples"], 24) << row;
    } else {
      EXPECT_GT(row["failed_samples"], 0) << row;
    }
  }
  EXPECT_EQ(angles["filtered"].size(), 19U);
  EXPECT_EQ(angles["fast-float"], angles["filtered"]);
}

TEST(Angles, AnUndecidedAnswerIsNotWrong) {
  for (const auto& row : rows_with({"--methods", "interval", "--families", "l", "--samples", "3"}))
    EXPECT_EQ(row["failed_samples"], 0) << row;
}

TEST(Angles, TheNumberOfThreadsAndAPauseChangeNothing) {
  run_tests::expect_that_threads_and_a_pause_change_nothing(
      commands::angles_command, {"--methods", "fast,thesis", "--families", "l", "--seed", "5"}, "9", "4",
      {"angles.csv"});
}

TEST(Angles, AnotherRunsCheckpointIsRefused) {
  const Scratch scratch;
  const auto folder = scratch.path / "run";
  run_tests::run_into(folder, commands::angles_command, {"--methods", "fast", "--families", "l", "--samples", "1"});
  const auto refused = run_tests::run_captured(
      commands::angles_command,
      {"--methods", "fast,filtered", "--families", "l", "--samples", "1", "--resume", "--output", folder.string()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("checkpoint.json: is of --methods fast, not of --methods fast,filtered"),
            std::string::npos)
      << refused.err;
}

}  // namespace
}  // namespace touchstone::angles

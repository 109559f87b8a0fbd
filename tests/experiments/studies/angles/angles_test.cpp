// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "experiments/commands.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::angles {
namespace {

using run_tests::Scratch;
using run_tests::text_of;

/// Runs the study into a folder, with these arguments besides. Returns its table.
std::string table_of(const std::filesystem::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--output", folder.string()});
  EXPECT_EQ(run_tests::run_captured(commands::angles_command, arguments).status, 0);
  return text_of(folder / "angles.csv");
}

/// The columns failed_samples and samples of a method, by angle.
std::map<int, std::pair<int, int>> counts_of(const std::string& table, const std::string& method) {
  std::map<int, std::pair<int, int>> counts;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string angle, name, failed, samples;
    std::getline(fields, angle, ',');
    std::getline(fields, name, ',');
    std::getline(fields, failed, ',');
    std::getline(fields, samples, ',');
    if (name == method) counts[std::stoi(angle)] = {std::stoi(failed), std::stoi(samples)};
  }
  return counts;
}

TEST(Angles, AMethodThatIsExactIsNeverWrongAndFloatsAreEverywhere) {
  const Scratch scratch;
  const std::string table =
      table_of(scratch.path / "run", {"--methods", "filtered,fast-float", "--families", "star,u", "--samples", "12"});
  const auto filtered = counts_of(table, "filtered"), floats = counts_of(table, "fast-float");
  ASSERT_EQ(filtered.size(), 19U);
  ASSERT_EQ(floats.size(), 19U);
  for (const auto& [angle, count] : filtered) {
    EXPECT_EQ(count.first, 0) << angle;
    EXPECT_GE(count.second, 12) << angle;
    EXPECT_LE(count.second, 24) << angle;
    EXPECT_GT(floats.at(angle).first, 0) << angle;
  }
}

TEST(Angles, AnUndecidedAnswerIsNotWrong) {
  const Scratch scratch;
  const std::string table =
      table_of(scratch.path / "run", {"--methods", "interval", "--families", "l", "--samples", "3"});
  for (const auto& [angle, count] : counts_of(table, "interval")) EXPECT_EQ(count.first, 0) << angle;
}

TEST(Angles, TheNumberOfThreadsAndAPauseChangeNothing) {
  const Scratch scratch;
  const std::vector<std::string> settings{"--methods", "fast,thesis", "--families", "l", "--seed", "5"};
  const auto run = [&](const char* folder, const char* samples, const char* threads, bool resume) {
    std::vector<std::string> arguments = settings;
    arguments.insert(arguments.end(), {"--samples", samples, "--threads", threads});
    if (resume) arguments.emplace_back("--resume");
    return table_of(scratch.path / folder, arguments);
  };
  const std::string whole = run("whole", "9", "1", false);
  run("parts", "4", "2", false);
  EXPECT_EQ(run("parts", "9", "2", true), whole);
}

TEST(Angles, AnotherRunsCheckpointIsRefused) {
  const Scratch scratch;
  const auto folder = scratch.path / "run";
  table_of(folder, {"--methods", "fast", "--families", "l", "--samples", "1"});
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

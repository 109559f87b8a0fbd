// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell run`: its files, its exit status, and what it refuses.
#include "tests/experiments/support/run_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

using run_tests::Ran;

Ran cell_run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"run", kAristo.string()});
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

TEST(CellRun, WritesTheTrajectoryAndWhatTheMethodsSaid) {
  const run_tests::Scratch scratch;
  const auto text = [&](const char* name) { return run_tests::text_of(scratch.path / name); };
  const Ran ran = cell_run({"--output", scratch.path.string(), "--methods", "filtered,thesis"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("to-machine       shoulder        +28  contact  at +27.492"), std::string::npos) << ran.out;
  const auto lines = [](const std::string& s) { return std::count(s.begin(), s.end(), '\n'); };
  EXPECT_EQ(lines(text("moves.csv")), 1 + 19);  // two of them straight down, two up
  EXPECT_NE(text("moves.csv").find("\n2,to-storage,base,contact,-149,-148.498862,2.4833,0.498862,148.49"),
            std::string::npos)
      << text("moves.csv");
  EXPECT_EQ(text("methods.csv").substr(0, 60), "method,asked,wrong_hits,wrong_misses,unsure,stops,share_low,");
  EXPECT_EQ(text("near.csv").substr(0, 24), "exponent,near,questions\n");
  EXPECT_EQ(lines(text("near.csv")), 1 + 61);
  std::istringstream stream(text("trajectory.csv"));
  std::vector<std::string> stops;
  for (std::string line; std::getline(stream, line);) stops.push_back(line);
  ASSERT_EQ(stops.size(), 1U + 607U);
  EXPECT_TRUE(stops[1 + 152].ends_with(",3,storage")) << stops[1 + 152];
  EXPECT_TRUE(stops[1 + 153].ends_with(",gripper")) << stops[1 + 153];
  const auto angles = [&](std::size_t stop) {
    return std::regex_replace(stops[1 + stop], std::regex("^(?:[^,]*,){3}((?:[^,]*,){6}).*"), "$1");
  };
  EXPECT_EQ(angles(606), angles(0));
  EXPECT_NE(text("run.json").find("touchstone cell run "), std::string::npos);
}

TEST(CellRun, SaysWhyItDidNotCompleteByItsExitStatusToo) {
  const Ran ran = cell_run({"--set", "step=6", "--methods", "fast", "--sphere-alone", "--thesis-order", "--explain"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.out.find("from the side: to-storage base -150: steps of 6 degrees pass over the contact"),
            std::string::npos)
      << ran.out;
}

TEST(CellRun, NamesTheKeyThatIsWrong) {
  const auto err = [](std::vector<std::string> arguments) {
    const Ran ran = cell_run(std::move(arguments));
    EXPECT_EQ(ran.status, 2) << ran.out;
    return run_tests::after_file(kAristo, ran.err);
  };
  EXPECT_EQ(err({"--set", "storage.height=-1"}), "storage.height: must not be negative, is -1");
  EXPECT_NE(err({"--methods", "nonsense"}).find("\"nonsense\""), std::string::npos);
}

}  // namespace
}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/harness/options.h"

#include <gtest/gtest.h>

namespace touchstone::harness {
namespace {

struct Command {
  CLI::App app;
  std::uint64_t seed = 7;
  unsigned threads = 3;
  std::vector<std::string> names{"all"}, files;

  Command() {
    add_seed(app, seed);
    add_threads(app, threads);
    add_names(app, "--method", names, "Methods");
    app.add_option("files", files);
  }
  void parse(const std::string& arguments) { app.parse(arguments); }
};

TEST(StudyOptions, KeepWhatTheVariablesHeldWhereNothingIsSaid) {
  Command command;
  command.parse("");
  EXPECT_EQ(command.seed, 7U);
  EXPECT_EQ(command.threads, 3U);
  EXPECT_EQ(command.names, std::vector<std::string>{"all"});
}

TEST(StudyOptions, TakeTheWholeRangeOfASeedAndOfThreads) {
  Command command;
  command.parse("--seed 18446744073709551615 --threads 1024");
  EXPECT_EQ(command.seed, 18446744073709551615U);
  EXPECT_EQ(command.threads, 1024U);
}

TEST(StudyOptions, RefuseWhatWouldWrapAround) {
  for (const char* wrong : {"--seed -1", "--seed 18446744073709551616", "--threads 0", "--threads -1", "--threads 1025",
                            "--threads 4294967297", "--seed 1.5"})
    EXPECT_THROW(Command().parse(wrong), harness::UsageError) << wrong;
}

TEST(StudyOptions, LeaveWhatStandsBehindAListOfNamesToOthers) {
  Command command;
  command.parse("--method fast,exact mesh.obj");
  EXPECT_EQ(command.names, (std::vector<std::string>{"fast", "exact"}));
  EXPECT_EQ(command.files, std::vector<std::string>{"mesh.obj"});
}

}  // namespace
}  // namespace touchstone::harness

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/commands.h"

namespace touchstone::commands {
namespace {

void run(std::vector<std::string> arguments) {
  CLI::App app("test");
  int status = 0;
  add_judge(app, status);
  add_cases(app);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
}

TEST(JudgeCommand, RefusesAnEngineWhoseNameIsNotUtf8) {
  EXPECT_THROW(run({"judge", "--exec", "cat # \xff", "/dev/null"}), harness::UsageError);
  EXPECT_NO_THROW(run({"judge", "--exec", "cat # \xc3\xa9", "/dev/null"}));
}

TEST(CasesCommand, RefusesNumbersThatMeanNothing) {
  EXPECT_THROW(run({"cases", "--vertices", "2"}), harness::UsageError);
  EXPECT_THROW(run({"cases", "--vertices", "131073"}), harness::UsageError);
  for (const char* option : {"--vertices", "--holes", "--seed", "--first", "--count"})
    for (const char* number : {"-1", "1.5", "many", "18446744073709551616"})
      EXPECT_THROW(run({"cases", option, number}), harness::UsageError) << option << ' ' << number;
  EXPECT_NO_THROW(run({"cases", "--count", "0", "--vertices", "3"}));
}

}  // namespace
}  // namespace touchstone::commands

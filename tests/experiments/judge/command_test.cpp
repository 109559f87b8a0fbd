// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "experiments/commands.h"

namespace touchstone::commands {
namespace {

TEST(JudgeCommand, RefusesAnEngineWhoseNameIsNotUtf8) {
  EXPECT_THROW(judge_command()({"--engine", "cat # \xff", "/dev/null"}), harness::UsageError);
  EXPECT_NO_THROW(judge_command()({"--engine", "cat # \xc3\xa9", "/dev/null"}));
}

TEST(CasesCommand, RefusesNumbersThatMeanNothing) {
  EXPECT_THROW(cases_command()({"--vertices", "2"}), harness::UsageError);
  EXPECT_THROW(cases_command()({"--vertices", "131073"}), harness::UsageError);
  for (const char* option : {"--vertices", "--holes", "--seed", "--first", "--samples"})
    for (const char* number : {"-1", "1.5", "many", "18446744073709551616"})
      EXPECT_THROW(cases_command()({option, number}), harness::UsageError) << option << ' ' << number;
  EXPECT_NO_THROW(cases_command()({"--samples", "0", "--vertices", "3"}));
}

}  // namespace
}  // namespace touchstone::commands

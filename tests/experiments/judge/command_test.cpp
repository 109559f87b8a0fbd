// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/commands.h"

namespace touchstone::judge {
namespace {

TEST(JudgeCommand, RefusesAnEngineWhoseNameIsNotUtf8) {
  EXPECT_THROW(commands::judge_command()({"--engine", "cat # \xff", "/dev/null"}), program::UsageError);
  EXPECT_NO_THROW(commands::judge_command()({"--engine", "cat # \xc3\xa9", "/dev/null"}));
}

TEST(CasesCommand, RefusesNumbersThatMeanNothing) {
  EXPECT_THROW(commands::cases_command()({"--vertices", "2"}), program::UsageError);
  EXPECT_THROW(commands::cases_command()({"--vertices", "131073"}), program::UsageError);
  for (const char* option : {"--vertices", "--holes", "--seed", "--first", "--samples"})
    for (const char* number : {"-1", "1.5", "many", "18446744073709551616"})
      EXPECT_THROW(commands::cases_command()({option, number}), program::UsageError) << option << ' ' << number;
  EXPECT_NO_THROW(commands::cases_command()({"--samples", "0", "--vertices", "3"}));
}

// What would take hours, or never end, is refused at once.
TEST(CasesCommand, RefusesNumbersThatNoPolygonOrSearchCanHave) {
  EXPECT_THROW(commands::cases_command()({"--holes", "1001"}), program::UsageError);
  EXPECT_THROW(commands::cases_command()({"--samples", "1099511627777"}), program::UsageError);
  EXPECT_THROW(commands::cases_command()({"--family", "random-simple", "--vertices", "1025"}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::judge

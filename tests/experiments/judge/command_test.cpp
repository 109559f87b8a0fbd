// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <exception>
#include <string>

#include "experiments/commands.h"
#include "tests/experiments/support/message_of.h"

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

/// Returns what the command says of the option with this value.
std::string fault(const std::string& option, const std::string& value, const std::string& family = "star") {
  return run_tests::message_of<std::exception>([&] { commands::cases_command()({"--family", family, option, value}); });
}

// What would take hours, or never end, is told at once, with the option and the limit.
TEST(CasesCommand, RefusesNumbersThatNoPolygonOrSearchCanHave) {
  EXPECT_EQ(fault("--holes", "1001"),
            R"(--holes: "1001" is not a whole number from 0 to 1000; see `touchstone cases --help`)");
  EXPECT_EQ(fault("--vertices", "131073"),
            R"(--vertices: "131073" is not a whole number from 3 to 131072; see `touchstone cases --help`)");
  EXPECT_EQ(fault("--vertices", "1025", "random-simple"),
            "--vertices 1025: outlines of the family random-simple have at most 1024");
  EXPECT_EQ(
      fault("--samples", "1099511627777"),
      R"(--samples: "1099511627777" is not a whole number from 0 to 1099511627776; see `touchstone cases --help`)");
}

}  // namespace
}  // namespace touchstone::judge

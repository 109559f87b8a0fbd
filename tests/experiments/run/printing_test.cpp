// SPDX-License-Identifier: GPL-3.0-or-later
// What a command prints: its text, its tables or nothing; and what it knows of standard output before it runs.
#include "experiments/run/printing.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace touchstone::run {
namespace {

struct Number {
  int x;
};

const Table<Number> kNumbers("a.csv", "a row", {{"x", "a number", &Number::x}});

/// Runs a command that prints a text and a table of 1 and 2. Returns what it prints; `folder`: where it wrote the
/// table.
std::string printed(const std::vector<std::string>& arguments, std::filesystem::path& folder) {
  Printing printing;
  Command command("measure", "Measures");
  declare_printing(command, printing);
  command.writes({kNumbers.description()});
  command.runs([&] {
    printing.print("text\n", [&](const std::filesystem::path& to) {
      kNumbers.write(folder = to, {{1}, {2}});
      EXPECT_TRUE(std::filesystem::exists(folder / "a.csv"));
    });
    return 0;
  });
  testing::internal::CaptureStdout();
  EXPECT_EQ(command(arguments), 0);
  return testing::internal::GetCapturedStdout();
}

TEST(Printing, IsOfTheTextOrTheTablesOrNothing) {
  std::filesystem::path folder;
  EXPECT_EQ(printed({}, folder), "text\n");
  EXPECT_EQ(printed({"--quiet"}, folder), "");
  EXPECT_EQ(folder, "");  // no table is written that nobody asked for
  EXPECT_EQ(nlohmann::json::parse(printed({"--json"}, folder)),
            nlohmann::json::parse(R"({"a.csv":[{"x":1},{"x":2}]})"));
  EXPECT_NE(folder, "");
  EXPECT_FALSE(std::filesystem::exists(folder));
  EXPECT_THROW(printed({"--json", "--quiet"}, folder), UsageError);
  testing::internal::GetCapturedStdout();
}

/// Runs a command with standard output at a file. Returns whether it ran; otherwise sets the complaint.
bool runs_with(const char* file, int flags, const std::vector<std::string>& arguments, std::string& complaint) {
  Printing printing;
  Command command("measure", "Measures");
  declare_printing(command, printing);
  bool ran = false;
  command.runs([&] {
    ran = true;
    return 0;
  });
  std::fflush(stdout);
  const int kept = dup(STDOUT_FILENO), other = open(file, flags);
  dup2(other, STDOUT_FILENO);
  close(other);
  try {
    command(arguments);
  } catch (const std::runtime_error& error) {
    complaint = error.what();
  }
  dup2(kept, STDOUT_FILENO);
  close(kept);
  return ran;
}

TEST(Printing, IsRefusedBeforeTheCommandRuns) {
  std::string complaint;
  EXPECT_TRUE(runs_with("/dev/null", O_WRONLY, {}, complaint)) << complaint;
  EXPECT_FALSE(runs_with("/dev/full", O_WRONLY, {}, complaint));
  EXPECT_EQ(complaint, "standard output: cannot be written: No space left on device");
  EXPECT_FALSE(runs_with("/dev/null", O_RDONLY, {"--json"}, complaint));
  EXPECT_EQ(complaint, "standard output: cannot be written: Bad file descriptor");
  EXPECT_TRUE(runs_with("/dev/full", O_WRONLY, {"--quiet"}, complaint));
}

}  // namespace
}  // namespace touchstone::run

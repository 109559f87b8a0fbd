// SPDX-License-Identifier: GPL-3.0-or-later
// What a command prints: its text or nothing; and what it knows of standard output before it runs.
#include "experiments/program/printing.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/program/command.h"

namespace touchstone::program {
namespace {

TEST(Printing, IsOfTheTextOrNothing) {
  testing::internal::CaptureStdout();
  print_result("text\n", false);
  print_result("not this\n", true);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "text\n");
}

/// Runs a command with standard output at a file. Returns whether it ran; otherwise sets the complaint.
bool runs_with(const char* file, int flags, const std::vector<std::string>& arguments, std::string& complaint) {
  bool quiet = false;
  Command command("measure", "Measures");
  declare_quiet(command, quiet);
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
  EXPECT_FALSE(runs_with("/dev/null", O_RDONLY, {}, complaint));
  EXPECT_EQ(complaint, "standard output: cannot be written: Bad file descriptor");
  EXPECT_TRUE(runs_with("/dev/full", O_WRONLY, {"--quiet"}, complaint));
}

}  // namespace
}  // namespace touchstone::program

// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a study: what its exit status tells a script.
#include "experiments/run/study.h"

#include <gtest/gtest.h>

#include "tests/experiments/support/scratch.h"

namespace touchstone::run {
namespace {

using run_tests::Scratch;

/// The exit status of a run whose pictures nobody can draw, for no script has this name.
int finish_without_pictures(const std::filesystem::path& folder, bool no_pictures, int status) {
  StudyOptions options;
  options.output = folder.string();
  options.no_pictures = no_pictures;
  const Processes alone;
  StudyRun run("no-such-study", 1, options, alone);
  return run.finish({.done = 1, .text = "", .status = status});
}

TEST(StudyRun, SaysByItsStatusThatPicturesAreMissingAndKeepsTheData) {
  const Scratch scratch;
  EXPECT_EQ(finish_without_pictures(scratch.path / "undrawn", false, 0), 1);
  EXPECT_TRUE(std::filesystem::exists(scratch.path / "undrawn" / "run.json"));
  EXPECT_EQ(finish_without_pictures(scratch.path / "unasked", true, 0), 0);
  EXPECT_EQ(finish_without_pictures(scratch.path / "failed", false, 3), 3) << "the study's own status goes first";
}

}  // namespace
}  // namespace touchstone::run

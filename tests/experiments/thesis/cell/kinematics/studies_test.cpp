// SPDX-License-Identifier: GPL-3.0-or-later
// `touchstone cell layout` and `touchstone cell missed`: what they count and write, whatever the threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/commands.h"
#include "experiments/thesis/cell/first_contact/first_contact.h"
#include "experiments/thesis/cell/first_contact/missed_study.h"
#include "experiments/thesis/cell/kinematics/layout_output.h"
#include "robust/exact/validate.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"

namespace touchstone::kinematics {
namespace {

using run_tests::Scratch;
using run_tests::text_of;

const std::atomic<bool> kGoOn{false}, kStop{true};

run_tests::Ran touchstone_cell(std::vector<std::string> arguments) {
  return run_tests::run_captured(commands::cell_command, std::move(arguments));
}

TEST(MissedStudy, CountsWhatStepsPassOver) {
  const MissedStudy study = study_missed(1, TOUCHSTONE_SAMPLES, 2, kGoOn, [](std::uint64_t) {});
  EXPECT_EQ(study.samples, std::uint64_t{TOUCHSTONE_SAMPLES});
  EXPECT_LE(study.widest, 1e-12);
  for (std::size_t r = 0; r < kRadii.size(); ++r)
    for (std::size_t s = 0; s < kSteps.size(); ++s) {
      const Missed& m = study.counts[r][s];
      EXPECT_EQ(m.early, 0U);
      EXPECT_GT(m.contacts, 9U * TOUCHSTONE_SAMPLES / 10);
      EXPECT_LE(m.missed, study.counts[r == 0 ? 0 : r - 1][s].missed);
    }
  EXPECT_EQ(study.counts.back()[1].missed, 0U);  // half a degree is less than 7 mm, the ball 12 mm wide
  EXPECT_GT(study.counts.front()[2].missed, study.counts.front()[2].contacts / 2);
}

TEST(MissedStudy, IsTheSameForAnyNumberOfThreads) {
  const Scratch scratch;
  std::vector<std::string> texts;
  for (const unsigned threads : {1U, 3U}) {
    write_missed(scratch.path, study_missed(7, 40, threads, kGoOn, [](std::uint64_t) {}));
    texts.push_back(text_of(scratch.path / "missed.csv"));
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(MissedStudy, DrawsSheetsThatTheSphereGoesThrough) {
  for (std::uint64_t n = 0; n < TOUCHSTONE_SAMPLES; ++n) {
    const ThroughSheet sample = draw_through_sheet(3, n);
    EXPECT_FALSE(exact::validate(sample.sheet).has_value()) << n;
    EXPECT_TRUE(first_contact(sample.arc, 1, {{}, {sample.sheet}}).has_value()) << n;
  }
}

// As many as the command draws by default. Some homes leave less room up than a move is long.
TEST(MissedStudy, DrawsEveryMoveWithinTheLimitsOfTheJoints) {
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint64_t n = 0; n < 2000; ++n) {
      double degrees = 0;
      ASSERT_NO_THROW(degrees = draw_through_sheet(seed, n).arc.degrees) << seed << ' ' << n;
      ASSERT_GE(degrees, 30) << seed << ' ' << n;
      ASSERT_LE(degrees, 45) << seed << ' ' << n;
    }
}

TEST(CellCommand, WritesWhatStepsPassOver) {
  const Scratch scratch;
  const run_tests::Ran ran =
      touchstone_cell({"missed", "--samples", "20", "--no-pictures", "--output", (scratch.path / "out").string()});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("20 moves of one joint"), std::string::npos) << ran.out;
  const std::string text = text_of(scratch.path / "out" / "missed.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + static_cast<long>(kRadii.size() * kSteps.size()));
  EXPECT_NE(text_of(scratch.path / "out" / "run.json").find("touchstone cell missed --samples 20"), std::string::npos);
  EXPECT_NE(touchstone_cell({"missed", "--samples", "-1"}).err.find("--samples"), std::string::npos);
}

// A folder stands where the picture should go.
TEST(CellCommand, SaysByItsStatusThatPicturesAreMissingAndKeepsTheData) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch.path / "out";
  std::filesystem::create_directories(folder / "cell-missed.svg" / "in the way");
  EXPECT_EQ(touchstone_cell({"missed", "--samples", "1", "--force", "--output", folder.string()}).status, 1);
  EXPECT_TRUE(std::filesystem::exists(folder / "missed.csv"));
}

TEST(LayoutStudy, StopsWhenItIsAskedTo) {
  std::uint64_t last = 0;
  EXPECT_FALSE(study_layout({}, kStop, [&](std::uint64_t done) { last = done; }).has_value());
  EXPECT_EQ(last, 1U);
}

// A small study by hand: the files hold the captions, the results beside them, and the label of what was chosen.
TEST(LayoutOutput, SetsWhatCameOutBesideTheCaptions) {
  LayoutStudy study;
  study.chosen = chosen_layout();
  for (std::size_t i = 0; i < kCases.size(); ++i) {
    const Station storage = study.chosen.storage(i, kCases[i].storage_angle);
    study.cases.push_back(rehearse(study.chosen, storage));
  }
  study.grid.push_back({{Coupling::Serial, Hand::Level}, {1, 2}, {}, "no layout"});
  study.choices.push_back({"material side", "mm", 40, 38, 42});
  const Scratch scratch;
  write_layout(scratch.path, study);
  const std::string moves = text_of(scratch.path / "moves.csv");
  EXPECT_NE(moves.find("1,2,base 149 CW; contact,base,contact,-149,"), std::string::npos) << moves;
  EXPECT_NE(moves.find("2,4,not captioned (11 derived),shoulder,cleared,-11,"), std::string::npos) << moves;
  EXPECT_NE(text_of(scratch.path / "choice.csv").find("material side,40,mm,C,38.000,42.000"), std::string::npos);
  EXPECT_NE(text_of(scratch.path / "family.csv").find("serial,level,1.000000,2.000000,,,,,,,,,no,no layout"),
            std::string::npos);
  EXPECT_NE(layout_table(study).find("by a layout of 0 of 1 home poses"), std::string::npos);
}

}  // namespace
}  // namespace touchstone::kinematics

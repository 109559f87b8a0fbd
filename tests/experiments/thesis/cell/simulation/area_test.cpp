// SPDX-License-Identifier: GPL-3.0-or-later
// Where the storage may stand.
#include "experiments/thesis/cell/area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <string>

#include "experiments/commands.h"
#include "tests/experiments/support/run_command.h"
#include "tests/experiments/support/scratch.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

std::vector<Tried> tried(const Grid& grid, unsigned threads = 1) {
  static const Cell cell = read_cell(kAristo);
  static const auto parts = build_model(cell);
  const std::atomic<bool> stop = false;
  return try_places(cell, parts, covered_aristo(), grid, {}, threads, stop, [](std::uint64_t) {}).value();
}

TEST(Area, ThePlacesOfBothCaseStudiesAreInIt) {
  const auto places = tried({{1, -33}, {480.2}, {242}});
  ASSERT_EQ(places.size(), 2U);
  for (const Tried& place : places) EXPECT_EQ(place.reason, "") << place.angle << " " << place.radius;
}

TEST(Area, SaysWhyThereIsNoPlaceElsewhere) {
  const auto far = tried({{1}, {900}, {242}})[0];
  EXPECT_EQ(far.cause, FailureCause::OutOfReach);
  EXPECT_TRUE(far.reason.starts_with("storage.radius: too far: material in slot \"A\" is ")) << far.reason;
  const auto high = tried({{1}, {500}, {1300}})[0];
  EXPECT_NE(high.reason.find("at this height the arm reaches it from above at no radius"), std::string::npos)
      << high.reason;
  const auto in_machine = tried({{67}, {621}, {300}})[0];
  EXPECT_EQ(in_machine.cause, FailureCause::InTheWay);
  EXPECT_NE(in_machine.reason.find("machine/"), std::string::npos) << in_machine.reason;
  const auto in_base = tried({{1}, {60}, {242}})[0];
  EXPECT_EQ(in_base.cause, FailureCause::InTheWay);
  EXPECT_NE(in_base.reason.find("at home Base/pedestal touches"), std::string::npos) << in_base.reason;
}

// Advice works.
TEST(Area, TheRadiiThatARefusalNamesAreThoseWithinReach) {
  for (const double height : {200, 242, 400}) {
    const std::string reason = tried({{1}, {900}, {height}})[0].reason;
    double least = 0, most = 0;
    const std::size_t at = reason.find("at radii from ");
    ASSERT_EQ(std::sscanf(reason.c_str() + std::min(at, reason.size()), "at radii from %lf to %lf", &least, &most), 2)
        << reason;
    const auto within = tried({{1}, {least, (least + most) / 2, most}, {height}}),
               beyond = tried({{1}, {most + 10}, {height}});
    for (const Tried& place : within) EXPECT_NE(place.cause, FailureCause::OutOfReach) << height << ' ' << place.reason;
    EXPECT_NE(beyond[0].reason.find("the upper face of the material is out of reach"), std::string::npos)
        << height << ' ' << beyond[0].reason;
  }
}

TEST(Area, IsTheSameForAnyNumberOfThreads) {
  const Grid grid{{-40, 60}, {300, 500, 700}, {242}};
  const auto one = tried(grid, 1), two = tried(grid, 2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].radius, two[i].radius);
    EXPECT_EQ(one[i].cause, two[i].cause);
    EXPECT_EQ(one[i].reason, two[i].reason);
  }
}

TEST(Area, TheCommandWritesEveryPlace) {
  const run_tests::Scratch scratch;
  const auto ran =
      run_tests::run_captured(commands::cell_command, {"area", kAristo.string(), "--angle-step", "90", "--length-step",
                                                       "300", "--no-pictures", "--output", scratch.path.string()});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto lines = [&](const char* name) {
    const std::string text = run_tests::text_of(scratch.path / name);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines("plan.csv"), 1 + 4 * 3);
  EXPECT_EQ(lines("heights.csv"), 1 + 3 * 3);
  EXPECT_EQ(lines("stations.csv"), 3);
  // Reasons name no file, so that two machines' results are the same.
  for (const char* name : {"plan.csv", "heights.csv"}) {
    const std::string text = run_tests::text_of(scratch.path / name);
    EXPECT_NE(text.find("out-of-reach"), std::string::npos) << name;
    EXPECT_EQ(text.find(kAristo.filename().string()), std::string::npos) << name;
  }
  EXPECT_NE(ran.out.find("angle x radius at height 242: "), std::string::npos) << ran.out;
}

TEST(Area, TheCommandRefusesAGridWithoutEnd) {
  const run_tests::Scratch scratch;
  const auto ran = run_tests::run_captured(
      commands::cell_command, {"area", kAristo.string(), "--length-step", "1e-3", "--output", scratch.path.string()});
  EXPECT_EQ(ran.status, 2);
  EXPECT_EQ(ran.err.rfind("--length-step 0.001: that is about ", 0), 0U) << ran.err;
}

}  // namespace
}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
// Ways that are found: what they promise, and that where the storage may stand is an interval.
#include "experiments/thesis/cell/simulation/way.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "experiments/thesis/cell/simulation/process.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

using kinematics::Angles;

Angles posed(double base, double shoulder, double elbow) {
  Angles angles = aristo().arm().home;
  angles[kBase] = base, angles[kShoulder] = shoulder, angles[kElbow] = elbow;
  return angles;
}

double height(const Workcell& workcell, const Angles& angles) { return workcell.arm().sphere_at(angles).center.z(); }

TEST(Way, GoesStraightWhereNothingStands) {
  const Workcell workcell = aristo();
  const Angles to = posed(-100, 40, 10);
  const Way way = find_way(workcell, workcell.arm().home, to, [](const Angles&, const Angles&) { return true; });
  EXPECT_TRUE(way.found);
  EXPECT_EQ(way.ends, std::vector<Angles>{to});
}

// A wall between two directions that ends at a height: the base turns only above it.
TEST(Way, LiftsTurnsAndLowersOverAWall) {
  const Workcell workcell = aristo();
  const Angles from = posed(0, 50, 0), to = posed(-80, 55, 5);
  const double wall = std::max(height(workcell, from), height(workcell, to)) + 60;
  const auto free = [&](const Angles& a, const Angles& b) {
    return a[kBase] == b[kBase] || (height(workcell, a) > wall && height(workcell, b) > wall);
  };
  const Way way = find_way(workcell, from, to, free);
  ASSERT_TRUE(way.found);
  ASSERT_EQ(way.ends.size(), 3U);
  EXPECT_EQ(way.ends[0][kBase], from[kBase]);
  EXPECT_EQ(way.ends[1][kBase], to[kBase]);
  EXPECT_GT(height(workcell, way.ends[1]), wall);
  EXPECT_EQ(way.ends[2], to);
  Angles at = from;
  for (const Angles& end : way.ends) {
    EXPECT_TRUE(free(at, end));
    EXPECT_NO_THROW(workcell.arm().chain.require_reachable(end));
    at = end;
  }
}

// The other way round, where the limits of the base allow it.
TEST(Way, TurnsTheOtherWayRound) {
  Cell cell = read_cell(kAristo);
  cell.robot.joints[0].lower = -300;
  const Workcell workcell(cell, build_model(cell), covered_aristo());
  const auto free = [](const Angles& a, const Angles& b) { return b[kBase] <= a[kBase]; };
  const Way way = find_way(workcell, posed(0, 40, 0), posed(80, 40, 0), free);
  ASSERT_TRUE(way.found);
  ASSERT_EQ(way.ends.size(), 1U);
  EXPECT_EQ(way.ends.back()[kBase], -280);
}

TEST(Way, SaysHowFarItGot) {
  const Workcell workcell = aristo();
  const auto free = [](const Angles& a, const Angles& b) { return a[kBase] == b[kBase]; };
  const Way way = find_way(workcell, posed(0, 40, 0), posed(-80, 50, 10), free);
  EXPECT_FALSE(way.found);
  ASSERT_EQ(way.ends.size(), 2U);  // lifted, but not turned
  EXPECT_EQ(way.ends[0][kBase], 0);
  EXPECT_NE(way.ends[1][kBase], 0);
  const Way none =
      find_way(workcell, posed(0, 40, 0), posed(-80, 50, 10), [](const auto&, const auto&) { return false; });
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.ends.size(), 1U);
}

std::string refusal(double angle, double radius, double height) {
  return simulate(aristo({fmt::format("storage.angle={}", angle), fmt::format("storage.radius={}", radius),
                          fmt::format("storage.height={}", height)}))
      .failure;
}

// The thesis's order alone completes at some of these places and not at others: it flickered from one to the next.
TEST(Way, RadiiThatCompleteAreAnInterval) {
  for (const double radius : {200, 390, 410, 430, 514, 544, 609}) EXPECT_EQ(refusal(1, radius, 242), "") << radius;
}

TEST(Way, HeightsThatCompleteAreAnInterval) {
  for (const double height : {25, 245, 289, 415}) EXPECT_EQ(refusal(-33, 609, height), "") << height;
}

TEST(Way, TheSectorOppositeTheStorageCompletes) {
  for (const double angle : {-180, -135, 150}) EXPECT_EQ(refusal(angle, 300, 242), "") << angle;
}

TEST(Way, ARefusalIsOneSentenceOfWhatStopsTheArm) {
  const Process process = simulate(aristo({"storage.angle=1", "storage.radius=170"}));
  EXPECT_EQ(process.cause, FailureCause::InTheWay);
  EXPECT_EQ(process.failure, process.stuck.value().reason);
  EXPECT_NE(process.failure.find("Axis1/body touches storage/deck"), std::string::npos) << process.failure;
  EXPECT_EQ(process.failure.find(';'), std::string::npos) << process.failure;
  EXPECT_GT(process.refused.size(), 3U);
}

// A pin that only the sphere can reach: between the fingers, beside the part, 1.25 mm above where the part lands.
TEST(Way, TheSphereIsTestedStraightDownToo) {
  const Process process =
      simulate(aristo({R"(machine.parts[6]={"name":"pin","box":{"from":[-0.5,4,0],"to":[0.5,5,43]}})"}));
  EXPECT_EQ(process.cause, FailureCause::InTheWay);
  EXPECT_NE(process.failure.find("sphere touches machine/pin"), std::string::npos) << process.failure;
}

}  // namespace
}  // namespace touchstone::cell

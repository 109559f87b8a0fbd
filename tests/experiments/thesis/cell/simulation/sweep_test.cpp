// SPDX-License-Identifier: GPL-3.0-or-later
// Whole moves: what is touched between the stops is found, and where it is.
#include "experiments/thesis/cell/simulation/sweep.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

/// A post that stands where the gripper passes, at an angle of the cell in degrees, from a radius on.
std::string post(double degrees, double radius, double half) {
  const double at = degrees * 0.017453292519943295;
  const double machine = -83 * 0.017453292519943295, x = radius * std::cos(at - machine) - 621.8,
               y = radius * std::sin(at - machine);
  return fmt::format(R"(machine.parts[6]={{"name":"post","box":{{"from":[{0},{1},-370],"to":[{2},{3},-20]}}}})",
                     x - half, y - half, x + half, y + half);
}

/// The state of the material before it is gripped.
MaterialTransfer in_storage(const Workcell& workcell) {
  return {0, StationSlot::Storage, 0, 0, {}, workcell.at(StationSlot::Storage).material};
}

/// The first of finely sampled angles at which the arm at rest touches something.
double sampled(const Sweep& sweep, const kinematics::Angles& from, Moved joint, double degrees,
               const MaterialTransfer& load) {
  std::uint64_t queries = 0;
  for (int i = 0; i <= 2000; ++i) {
    kinematics::Angles at = from;
    at[joint] += degrees * i / 2000;
    if (sweep.at_rest(at, load, queries)) return std::abs(degrees) * i / 2000;
  }
  return -1;
}

TEST(Sweep, FindsWhatIsTouchedBetweenTheStops) {
  for (const double where : {-21.3, -60.6, -100.4}) {
    const Workcell workcell = aristo({post(where, 500, 4)});
    const Sweep sweep(workcell);
    const MaterialTransfer load = in_storage(workcell);
    std::uint64_t queries = 0;
    kinematics::Angles home = workcell.arm().home;
    const auto found = sweep.along(home, kBase, -140, load, queries);
    ASSERT_TRUE(found) << where;
    EXPECT_NE(found->what.find("machine/post"), std::string::npos) << found->what;
    const double first = sampled(sweep, home, kBase, -140, load);
    ASSERT_GE(first, 0);
    EXPECT_LE(found->degrees, first);
    EXPECT_GT(found->degrees, first - 0.3);
    EXPECT_FALSE(sweep.along(home, kBase, -std::floor(found->degrees), load, queries));
    EXPECT_GT(queries, 10U);
  }
}

TEST(Sweep, FindsNothingWhereNothingIs) {
  const Workcell workcell = aristo();
  const Sweep sweep(workcell);
  std::uint64_t queries = 0;
  const MaterialTransfer load = in_storage(workcell);
  EXPECT_FALSE(sweep.at_rest(workcell.arm().home, load, queries));
  EXPECT_FALSE(sweep.along(workcell.arm().home, kBase, 90, load, queries));
  const auto raised = sweep.along(workcell.arm().home, kElbow, 40, load, queries);
  EXPECT_FALSE(raised) << raised->what;
}

// The hand stays clear of the floor, and of the robot's own foot.
TEST(Sweep, KnowsTheFloorAndTheArmItself) {
  const Workcell workcell = aristo();
  const Sweep sweep(workcell);
  std::uint64_t queries = 0;
  const MaterialTransfer load = in_storage(workcell);
  kinematics::Angles low = workcell.arm().home;
  low[kShoulder] += 55;
  const auto down = sweep.along(low, kElbow, -30, load, queries);
  ASSERT_TRUE(down);
  EXPECT_NE(down->what.find("the floor"), std::string::npos) << down->what;
  const auto folded = sweep.along(workcell.arm().home, kElbow, -90, load, queries);
  ASSERT_TRUE(folded);
  EXPECT_TRUE(folded->what.find("Base/") != std::string::npos || folded->what.find("Axis1/") != std::string::npos ||
              folded->what.find("the floor") != std::string::npos)
      << folded->what;
}

// What rests on a floor leaves it, and does not go through it.
TEST(Sweep, HeldMaterialRestsOnWhatLiesBelowIt) {
  const Workcell workcell = aristo();
  const Sweep sweep(workcell);
  std::uint64_t queries = 0;
  kinematics::Angles there = workcell.arm().home;
  there[kElbow] -= 3, there[kBase] -= 149;
  const Pose& lies = workcell.at(StationSlot::Storage).material->pose;
  const MaterialTransfer held{0, std::nullopt, 0, 0, within(inverse(workcell.arm().link_poses(there).back()), lies)};
  EXPECT_FALSE(sweep.along(there, kElbow, 38, held, queries));
  const auto down = sweep.along(there, kElbow, -5, held, queries);
  ASSERT_TRUE(down);
  EXPECT_EQ(down->degrees, 0);
  EXPECT_NE(down->what.find("material touches storage/deck"), std::string::npos) << down->what;
  const auto aside = sweep.along(there, kBase, 10, held, queries);
  ASSERT_TRUE(aside);
  EXPECT_NEAR(aside->degrees, 1.2, 0.3);  // 10 mm to the wall of its pocket
}

}  // namespace
}  // namespace touchstone::cell

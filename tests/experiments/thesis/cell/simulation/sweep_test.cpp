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

// Things that stand must not overlap; what lies within the box of another thing without touching it does not.
std::string overlap_under(const std::vector<std::string>& changes) {
  const auto found = overlap_of_things(aristo(changes));
  return found ? found->what : "";
}

const std::string
    kPost = R"({"name": "post", "box": {"from": [-5, -5, 0], "to": [5, 5, 50]}, "move": [-900, 0, 0]})",
    kPipe = R"({"name": "pipe", "difference": [
  {"box": {"from": [-50, -50, 0], "to": [50, 50, 100]}}, {"box": {"from": [-20, -20, -1], "to": [20, 20, 101]}}],
  "move": [-900, 0, 0]})",
    kBlock = R"({"name": "block", "box": {"from": [-50, -50, -1], "to": [50, 50, 100]}, "move": [-900, 0, 0]})";

TEST(Overlap, ThereIsNoneInTheCell) { EXPECT_EQ(overlap_under({}), ""); }

TEST(Overlap, OfAllThingsIsFound) {
  EXPECT_EQ(overlap_under({"obstacles=[" + kPost + "]"}), "");
  EXPECT_EQ(overlap_under({"obstacles=[" + kPost + "]", "obstacles[0].move=[-463, -278, 0]"}), "");  // below the deck
  EXPECT_NE(overlap_under({"obstacles=[" + kPost + "]", "obstacles[0].move=[-400, -250, 200]"}), "");
  EXPECT_EQ(overlap_under({"obstacles=[" + kPost + ", " + kBlock + "]"}), "post and block stand one in the other");
  EXPECT_EQ(overlap_under({"obstacles=[" + kBlock + ", " + kPost + "]"}), "block and post stand one in the other");
  EXPECT_EQ(overlap_under({"storages[0]=@storage", "storages[0].name=rack", "storages[0].angle=12"}).find("storage/"),
            0U);
  EXPECT_NE(overlap_under({"machines[0]=@machine", "machines[0].name=mill", "machines[0].angle=-120"}), "");
  EXPECT_EQ(overlap_under({"robots[0]=@robot", "robots[0].gripper=@gripper", "robots[0].name=second",
                           "robots[0].place=[300, 0]"}),
            "");  // two robots side by side: the one that moves is tested when it moves
}

// An obstacle wholly inside a link, the foot or the gripper, and a link wholly inside an obstacle, touch nothing.
TEST(Overlap, WithTheArmAtHomeIsFound) {
  const auto nested = [](const std::string& box) {
    const auto found = nested_at_home(aristo({R"(obstacles[0]={"name": "bug", "box": )" + box + "}"}));
    return found ? found->what : "";
  };
  EXPECT_EQ(nested(R"({"from": [-5, -5, 100], "to": [5, 5, 110]})"), "Base/pedestal and bug stand one in the other");
  EXPECT_EQ(nested(R"({"from": [-5, -5, 260], "to": [5, 5, 270]})"), "Axis1/body and bug stand one in the other");
  EXPECT_NE(nested(R"({"from": [-900, -900, -900], "to": [900, 900, 900]})"), "");
  EXPECT_EQ(nested(R"({"from": [-900, 0, 0], "to": [-890, 5, 5]})"), "");
  EXPECT_FALSE(nested_at_home(aristo()));
  EXPECT_EQ(simulate(aristo({R"(obstacles[0]={"name": "bug", "box": {"from": [-5, -5, 260], "to": [5, 5, 270]}})"}))
                .failure.substr(0, 7),
            "at home");
}

// Parts of one thing need not stand next to each other in the list of all parts.
TEST(Overlap, APieceLiesInItsOwnStorage) {
  EXPECT_EQ(overlap_under({"storages[0]=@storage", "storages[0].name=rack", "storages[0].angle=200",
                           "storages[1]=@storage", "storages[1].name=shelf", "storages[1].angle=120",
                           "materials[0]=@material", "materials[0].name=second", "materials[0].storage=rack"}),
            "");
}

// A post in a pipe lies within the pipe's box.
TEST(Overlap, WhatIsWithinTheHollowOfAnotherStandsFree) {
  EXPECT_EQ(overlap_under({"obstacles=[" + kPipe + ", " + kPost + "]"}), "");
}

}  // namespace
}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
// Things that stand must not overlap; what lies within the box of another thing without touching it does not.
#include "experiments/thesis/cell/simulation/overlap.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

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

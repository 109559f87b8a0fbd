// SPDX-License-Identifier: GPL-3.0-or-later
// Several robots, storages, machines, pieces, obstacles and virtual objects: which belongs to which, where they stand
// in the frame of the robot that moves, and what is refused.
#include "experiments/thesis/cell/model/plant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/thesis/cell/model/model.h"
#include "experiments/thesis/cell/model/poses.h"
#include "experiments/thesis/cell/model/read_cell.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::cell {
namespace {

using run_tests::kAristo;

const std::vector<std::string> kSecondRobot{"robots[0]=@robot", "robots[0].gripper=@gripper", "robots[0].name=second",
                                            "robots[0].place=[-1900, 100]", "robots[0].turn=150"};
const std::vector<std::string> kRack{"storages[0]=@storage", "storages[0].name=rack", "storages[0].angle=120"};

std::vector<std::string> operator+(std::vector<std::string> all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// What the Aristo's cell is refused for under changes, after the name of the file.
std::string fault_of_plant(const std::vector<std::string>& changes) {
  return run_tests::after_file(kAristo,
                               run_tests::message_of<BadCell>([&] { return read_plant(kAristo, {}, changes); }));
}

std::vector<std::string> names(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

TEST(Plant, AFileOfOneIsAPlantOfOne) {
  const Plant plant = read_plant(kAristo);
  EXPECT_EQ(plant.robots.size() + plant.storages.size() + plant.machines.size() + plant.pieces.size(), 4U);
  const Cell cell = cell_of(plant, 0);
  EXPECT_TRUE(cell.obstacles.empty());
  EXPECT_EQ(names(cell.storage.parts), std::vector<std::string>{"deck"});  // not the piece that is handled
  EXPECT_TRUE(cell.zones.empty());
  EXPECT_EQ(cell.storage.name, "storage");
  EXPECT_EQ(cell.labels, plant.labels);
}

TEST(Plant, WhatAPieceIsNotHandledByStands) {
  const Plant plant = read_plant(
      kAristo, {},
      kSecondRobot + kRack +
          std::vector<std::string>{"obstacles[0]={\"name\": \"fence\", \"box\": {\"from\": [0, 0, 0], \"to\": [1, 2, "
                                   "3]}, \"move\": [900, 900, 0]}",
                                   "materials[0]=@material", "materials[0].name=other", "materials[0].storage=rack"});
  const Cell first = cell_of(plant, 0), second = cell_of(plant, 1);
  const auto has = [](const Cell& cell, const std::string& name) {
    return std::ranges::count(names(cell.obstacles), name);
  };
  EXPECT_EQ(has(first, "rack/deck"), 1);
  EXPECT_EQ(has(first, "rack/stand"), 1);
  EXPECT_EQ(has(first, "rack/other"), 1);
  EXPECT_EQ(has(first, "second/Axis2/fork"), 1);
  EXPECT_EQ(has(first, "second/gripper/Gripper1"), 1);
  EXPECT_EQ(has(first, "fence"), 1);
  EXPECT_EQ(has(first, "storage/deck"), 0);
  EXPECT_EQ(has(second, "storage/deck"), 1);
  EXPECT_EQ(has(second, "storage/material"), 1);
  EXPECT_EQ(has(second, "rack/deck"), 0);
  EXPECT_EQ(second.storage.name, "rack");
  EXPECT_EQ(second.label("storage.radius"), Label::Chosen);
}

/// A piece in the storage that the robot serves stands on it, and goes where it goes.
TEST(Plant, PiecesStandOnTheirStorage) {
  const Plant plant =
      read_plant(kAristo, {}, {"materials[0]=@material", "materials[0].name=other", "materials[0].slot=C"});
  const Cell cell = cell_of(plant, 0);
  const auto piece = std::ranges::find(cell.storage.parts, "other", &Part::name);
  ASSERT_NE(piece, cell.storage.parts.end());
  EXPECT_EQ(piece->solid.pose.translation, cell.storage.slots[2].place);
}

/// The same arrangement, seen by the second robot, wherever that stands: what is about its axis is as it was, and
/// distances between things do not change.
TEST(Plant, ThingsAreSeenFromTheRobotThatMoves) {
  const auto moved =
      kSecondRobot + std::vector<std::string>{"material.robot=second", "storage.about=second", "machine.about=second"};
  const Cell own = read_cell(kAristo, {}, moved), alone = read_cell(kAristo);
  EXPECT_EQ(pose_of(own.storage), pose_of(alone.storage));
  EXPECT_EQ(pose_of(own.machine), pose_of(alone.machine));

  const Plant plant = read_plant(kAristo, {}, kSecondRobot + kRack);
  Plant by_second = plant;
  by_second.pieces[0].robot = 1;
  const Cell first = cell_of(plant, 0), second = cell_of(by_second, 0);
  const Pose frame = plant.robots[1].frame;
  for (const auto& [one, other] : {std::pair(&first.storage, &second.storage), {&first.machine, &second.machine}}) {
    const Pose expected = pose_of(*one), found = within(frame, pose_of(*other));
    EXPECT_LT((expected.translation - found.translation).norm(), 1e-9);
    EXPECT_LT((expected.rotation - found.rotation).norm(), 1e-12);
  }
  const auto place = [](const Cell& cell, const std::string& name) {
    return std::ranges::find(cell.obstacles, name, &Part::name)->solid.pose.translation;
  };
  const Eigen::Vector3d rack = frame * place(second, "rack/deck");
  EXPECT_LT((rack - place(first, "rack/deck")).norm(), 1e-9);
  const Eigen::Vector3d foot = frame * place(second, "robot/Base/pedestal");
  EXPECT_LT(foot.norm(), 1e-9);
}

TEST(Plant, AskedWhichItNamesKeyAndChoice) {
  EXPECT_EQ(fault_of_plant(kRack), "");  // the key `storage` says which
  EXPECT_EQ(fault_of_plant(kRack + std::vector<std::string>{"material.storage=shelf"}),
            "material.storage: \"shelf\" is not one of storage, rack");
  EXPECT_EQ(
      fault_of_plant(kRack + kRack +
                     std::vector<std::string>{"storages[1]=@storages[0]", "storages[1].name=third", "storage=null"}),
      "material: must say by \"storage\" which: there are rack, third");
  EXPECT_EQ(fault_of_plant({"storages[0]=@storage"}), "storages[0]: the key \"name\" is missing");
  EXPECT_EQ(fault_of_plant({"storages[0]=@storage", "storages[0].name=machine"}),
            "storages[0].name: a link, or something else, has this name");
  EXPECT_EQ(fault_of_plant({"storages[0]=@storage", "storages[0].name=Axis1"}),
            "storages[0].name: a link, or something else, has this name");
  EXPECT_EQ(fault_of_plant(kRack + std::vector<std::string>{"storages[0].radius=3000"}), "");  // nobody goes there
  EXPECT_TRUE(fault_of_plant(kRack + std::vector<std::string>{"storages[0].radius=3000", "material.storage=rack"})
                  .starts_with("storages[0].radius: too far: "));
  EXPECT_EQ(fault_of_plant({"materials[0]=@material", "materials[0].name=other"}),
            "materials[0].slot: \"material\" lies there");
  EXPECT_EQ(fault_of_plant({"robots[0]=@robot", "robots[0].name=second"}), "robots[0]: the key \"gripper\" is missing");
  EXPECT_EQ(fault_of_plant({"storages[0]=@rack"}), "storages[0]: there is no value at rack");
  EXPECT_EQ(fault_of_plant({"storage.about=second"}), "storage.about: \"second\" is not one of robot");
}

TEST(Plant, ZonesAreChecked) {
  const auto zone = [](const std::string& shape) {
    return fault_of_plant({"zones[0]={\"name\": \"z\", " + shape + "}"});
  };
  EXPECT_EQ(zone(R"("sphere": {"at": [0, 0, 0], "radius": 1})"), "");
  EXPECT_EQ(zone(R"("face": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "stops": true)"), "");
  EXPECT_EQ(zone(R"("stops": true)"), "zones[0]: has no shape: face, box, sphere or capsule");
  EXPECT_EQ(zone(R"("box": {"from": [0, 0, 0], "to": [1, 0, 1]})"),
            "zones[0].box: \"from\" must be less than \"to\" in each coordinate");
  EXPECT_EQ(zone(R"("face": [[0, 0, 0], [2, 0, 0], [1, 0.5, 0], [0, 2, 0]])"),
            "zones[0].face: its corners do not turn in one direction: a face is convex");
  EXPECT_EQ(zone(R"("face": [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])"),
            "zones[0].face: its corners are not in one plane");
  EXPECT_EQ(zone(R"("face": [[0, 0, 0], [1, 0, 0], [2, 0, 0]])"), "zones[0].face: its corners lie on a line");
  EXPECT_EQ(zone(R"("sphere": {"at": [0, 0, 0], "radius": 1}, "stops": 1)"), "zones[0].stops: must be true or false");
}

}  // namespace
}  // namespace touchstone::cell

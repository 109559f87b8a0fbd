// SPDX-License-Identifier: GPL-3.0-or-later
// The whole process of the cell: its results are those of the captions, and every stop is what is promised of it.
#include "experiments/thesis/cell/simulation/process.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/methods/registry.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/kinematics/layout_study.h"
#include "robust/exact/exact.h"
#include "tests/experiments/support/cells.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

bool touches(const Ball& ball, const scene::Faces& faces) {
  return std::ranges::any_of(faces.triangles,
                             [&](const Triangle& t) {
                               return exact::contact(ball, Polygon({t.a, t.b, t.c}));
                             }) ||
         std::ranges::any_of(faces.polygons, [&](const Polygon& p) { return exact::contact(ball, p); });
}

// The real arm's layout: its hand stays level, and what it grips from above it sets down there and takes home again.
// Its meshes are tetrahedra here, and there is a table to set it down on.
TEST(Process, TheRealArmCarriesItsPartFromAboveAndBack) {
  const run_tests::MelfaMeshes meshes;
  const Cell cell = read_cell(kAristo.parent_path() / "melfa.json", meshes.scratch.path, {kMelfaTable});
  const Workcell workcell(cell, build_model(cell));
  const Process process = simulate(workcell);
  EXPECT_EQ(process.failure, "");
  EXPECT_EQ(process.stops.back().commanded, workcell.arm().home);
  ASSERT_EQ(process.transfers.size(), 5U);
  for (const std::size_t i : {1U, 3U}) EXPECT_TRUE(process.transfers[i].grip) << i;
  const Pose home = workcell.arm().link_poses(workcell.arm().home).back();
  for (const Stop& stop : process.stops) {
    const Pose flange = workcell.arm().link_poses(stop.commanded).back();
    EXPECT_LT((flange.rotation.col(0) - home.rotation.col(0)).norm(), 1e-12);
  }
}

// By the cell's file, and by the layout that was solved for the captions and knows of no more than the material, the
// same joints make the same moves to the machine, to the degree.
TEST(Process, ItsMovesAreThoseOfTheChosenLayout) {
  for (std::size_t number = 0; number < kinematics::kCases.size(); ++number) {
    const Process path = kinematics::rehearse_case(kinematics::chosen_layout(), number);
    const Process process = simulate(aristo(number == 0 ? std::vector<std::string>{} : kSecondCase));
    EXPECT_EQ(process.failure, "");
    ASSERT_GT(process.moves.size(), path.moves.size());
    EXPECT_GT(process.moves[path.moves.size()].phase, Phase::ToMachine);
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      EXPECT_EQ(process.moves[i].joint, path.moves[i].joint) << "case " << number + 1 << ", move " << i + 1;
      EXPECT_EQ(process.moves[i].degrees, path.moves[i].degrees) << "case " << number + 1 << ", move " << i + 1;
      EXPECT_NEAR(process.moves[i].exact, path.moves[i].exact, 1e-9) << "case " << number + 1 << ", move " << i + 1;
    }
  }
}

/// A box, as its centre, the columns of its axes and half its sizes.
struct OrientedBox {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;
  Eigen::Vector3d half;
};

OrientedBox placed(const Pose& pose, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {pose * ((low + high) / 2), pose.rotation, (high - low) / 2};
}

/// By how much two boxes overlap along the direction of least overlap; negative if they are apart. Gottschalk's test.
double overlap_of_boxes(const OrientedBox& a, const OrientedBox& b) {
  double least = std::numeric_limits<double>::infinity();
  const auto along = [&](const Eigen::Vector3d& direction) {
    const double length = direction.norm();
    if (length < 1e-9) return;
    const double reach = (direction.transpose() * a.axes).cwiseAbs() * a.half +
                         ((direction.transpose() * b.axes).cwiseAbs() * b.half).value();
    least = std::min(least, (reach - std::abs(direction.dot(a.center - b.center))) / length);
  };
  for (int i = 0; i < 3; ++i) {
    along(a.axes.col(i)), along(b.axes.col(i));
    for (int j = 0; j < 3; ++j) along(a.axes.col(i).cross(b.axes.col(j)));
  }
  return least;
}

// An independent test by boxes: the part, the fingers and the palm, the vice's base and jaws, the deck. Nothing
// overlaps, except for the part that rests on the floor of its place, at any stop of both case studies.
TEST(Process, PartGripperViceAndDeckOverlapAtNoStop) {
  for (const auto& changes : {std::vector<std::string>{}, kSecondCase}) {
    const Workcell workcell = aristo(changes);
    const Process process = simulate(workcell);
    ASSERT_EQ(process.failure, "");
    const Pose machine = pose_of(workcell.cell().machine), storage = pose_of(workcell.cell().storage);
    const std::vector<OrientedBox> fixed{
        placed(machine, {-30, -81.8, -60}, {50, 38.2, 0}), placed(machine, {-30, -81.8, 0}, {50, -51.8, 25}),
        placed(machine, {-30, 8.2, 0}, {50, 38.2, 25}),    placed(machine, {-60, -200, -120}, {100, 200, -60}),
        placed(machine, {20, -80, 230}, {200, 80, 400}),   placed(storage, {-80, -140, -20}, {80, 100, -3}),
        placed(storage, {-80, -140, -3}, {-30, 100, 0}),   placed(storage, {30, -140, -3}, {80, 100, 0}),
        placed(storage, {-30, -61.8, -3}, {30, -51.8, 0})};
    for (std::size_t i = 0; i < process.stops.size(); ++i) {
      const Pose flange = workcell.arm().link_poses(process.stops[i].commanded).back();
      const MaterialTransfer& last = process.holding(i);
      const Pose lies = last.slot ? last.lies->pose : within(flange, *last.in_flange);
      const OrientedBox part = placed(lies, {-20, -20, 0}, {20, 20, 40});
      for (const OrientedBox& hand :
           {placed(flange, {-45, -15, -75}, {-25, 15, 0}), placed(flange, {25, -15, -75}, {45, 15, 0}),
            placed(flange, {-25, -15, -30}, {25, 15, 0})}) {
        EXPECT_LT(overlap_of_boxes(hand, part), 0) << "stop " << i;
        for (const OrientedBox& box : fixed) EXPECT_LT(overlap_of_boxes(hand, box), 0) << "stop " << i;
      }
      for (const OrientedBox& box : fixed) EXPECT_LT(overlap_of_boxes(part, box), 1e-9) << "stop " << i;
    }
  }
}

// The part goes through the vice and the hand past the part if nobody looks: with the wrist locked, and the sphere
// alone tested, as in the thesis. With matter the process stops and says why.
TEST(Process, WhatIsCarriedIsMatter) {
  const Workcell workcell = aristo({"machine.slots[0].place=[0,-30,0]", "machine.slots[0].aim=[0,-8.2]"});
  EXPECT_EQ(simulate(workcell, {.sphere_alone = true}).failure, "");
  const Process process = simulate(workcell, {.finds_ways = false});
  EXPECT_EQ(process.cause, FailureCause::InTheWay);
  EXPECT_NE(process.failure.find("material touches machine/vice"), std::string::npos) << process.failure;
}

TEST(Process, SaysWhyTheGripperDoesNotHold) {
  const std::string loose = simulate(aristo({"gripper.fingers.stroke=3.5"})).failure;
  EXPECT_NE(loose.find("to-storage: the gripper does not hold the material in the storage: gripper/Finger1 closes by "
                       "3.5 mm and touches nothing"),
            std::string::npos)
      << loose;
}

TEST(Process, LetsGoOnlyWithinTheTolerance) {
  const Process process = simulate(aristo({"material.tolerance.distance=1"}), {.finds_ways = false});
  EXPECT_NE(process.failure.find("withdraw: the material would be let go 1.4 mm and 0.0 degrees from its place in the "
                                 "machine, which is more than 1 and 10"),
            std::string::npos)
      << process.failure;
}

TEST(Process, RefusesAStorageThatStandsInTheMachine) {
  const Process process = simulate(aristo({"storage.angle=67", "storage.radius=500"}));
  EXPECT_EQ(process.cause, FailureCause::InTheWay);
  EXPECT_TRUE(process.failure.starts_with("at home storage/")) << process.failure;
  EXPECT_NE(process.failure.find(" stands in machine/"), std::string::npos) << process.failure;
  EXPECT_TRUE(process.moves.empty());
}

// In the notch of a U the sum of angles says contact 6 mm before the sphere touches: the robot stops there, holds the
// part by its ends, and runs it into the vice.
TEST(Process, TheThesissMethodStopsInAir) {
  const auto changes = preset(kAristo, "U-part");
  const Workcell workcell = aristo(changes);
  const Process right = simulate(workcell, {.drive = methods::find_method("filtered")});
  EXPECT_EQ(right.failure, "");
  EXPECT_FALSE(right.moves[1].wrong);
  const Process process = simulate(workcell, {.drive = methods::find_method("thesis")});
  ASSERT_GE(process.moves.size(), 2U);
  ASSERT_TRUE(process.moves[1].wrong);
  EXPECT_EQ(process.moves[1].wrong->early, 3);
  EXPECT_NEAR(process.moves[1].wrong->gap, 5.9, 0.1);
  EXPECT_NE(process.failure.find("material touches machine/vice"), std::string::npos) << process.failure;
}

// At 24 degrees and more the storage may reach into the machine.
TEST(Process, TheBaseTurnsAsTheCaptionsImplyForEveryAngleOfTheStorage) {
  for (int angle = -60; angle <= 60; angle += 4)
    for (const bool second : {false, true}) {
      const std::string at = "storage.angle=" + std::to_string(angle);
      const Workcell workcell = aristo(second ? std::vector{kSecondCase[1], at} : std::vector{at});
      const Process process = simulate(workcell);
      if (angle >= 24 && !process.failure.empty()) {
        EXPECT_NE(process.failure.find("machine/"), std::string::npos) << at;
        continue;
      }
      ASSERT_EQ(process.failure, "") << at;
      EXPECT_EQ(process.turned(kBase, Phase::ToStorage), -150 + angle) << at;
      EXPECT_EQ(process.turned(kBase, Phase::ToMachine), 67 - angle) << at;
      const auto net = [&](Moved joint) {
        return process.turned(joint, Phase::ToStorage) + process.turned(joint, Phase::ToMachine);
      };
      EXPECT_EQ(net(kElbow), 35) << at;
      EXPECT_EQ(net(kShoulder), 28) << at;
    }
}

TEST(Process, ItEndsAtHomeWithTheMaterialBackInItsSlot) {
  for (const auto& changes : {std::vector<std::string>{},
                              kSecondCase,
                              {"material.slot=A"},
                              {"material.slot=C"},
                              {"storage.height=200"},
                              {"storage.radius=520"}}) {
    const Workcell workcell = aristo(changes);
    const Process process = simulate(workcell);
    ASSERT_EQ(process.failure, "") << (changes.empty() ? "" : changes[0]);
    EXPECT_EQ(process.stops.back().commanded, workcell.arm().home);
    ASSERT_EQ(process.transfers.size(), 5U);
    EXPECT_EQ(process.transfers[1].slot, std::nullopt);
    EXPECT_EQ(process.transfers[2].slot, StationSlot::Machine);
    EXPECT_EQ(process.transfers[3].slot, std::nullopt);
    EXPECT_EQ(process.transfers[4].slot, StationSlot::Storage);
  }
}

TEST(Process, StopsAreOneStepOfOneJointApart) {
  const Workcell workcell = aristo({"step=0.5"});
  const Process process = simulate(workcell, {.finds_ways = false});
  ASSERT_GE(process.moves.size(), 5U);
  for (std::size_t i = 1; i < process.stops.size() && process.stops[i].move < process.moves.size(); ++i) {
    if (process.moves.at(process.stops[i].move).rise != 0) continue;
    const auto& before = process.stops[i - 1].commanded;
    const auto& after = process.stops[i].commanded;
    double turned = 0;
    int joints = 0;
    for (std::size_t j = 0; j < after.size(); ++j)
      if (after[j] != before[j]) turned = std::abs(after[j] - before[j]), ++joints;
    EXPECT_EQ(joints, 1) << i;
    EXPECT_NEAR(turned, 0.5, 1e-9) << i;
  }
}

// At every stop but those at which something is gripped or put down, and the lift after that, the sphere is clear.
TEST(Process, AMoveUntilContactEndsAtTheFirstStopThatTouchesExactly) {
  for (const auto& changes : {std::vector<std::string>{}, kSecondCase}) {
    const Workcell workcell = aristo(changes);
    const Process process = simulate(workcell);
    std::size_t contacts = 0;
    for (std::size_t i = 1; i < process.stops.size(); ++i) {
      const Stop& stop = process.stops[i];
      const Move& move = process.moves.at(stop.move);
      EXPECT_FALSE(touches(stop.sphere, workcell.obstacles().faces)) << "stop " << i;
      if (!stop.target) continue;
      const Workplace& place = workcell.at(*stop.target);
      const MaterialTransfer& state = process.holding(i);
      const scene::Faces& target = (state.slot == stop.target ? state.lies : place.copy)->faces;
      EXPECT_EQ(touches(stop.sphere, target), stop.touched.has_value()) << "stop " << i;
      if (move.until != Until::Contact) continue;
      const bool last = i + 1 == process.stops.size() || process.stops[i + 1].move != stop.move;
      EXPECT_EQ(stop.touched.has_value(), last) << "stop " << i;
      if (!last) continue;
      ++contacts;
      ASSERT_TRUE(move.contact);
      EXPECT_LE(move.contact->high, std::abs(move.degrees));
      EXPECT_GT(move.contact->low, std::abs(move.degrees) - workcell.cell().step);
      EXPECT_LE(move.contact->high - move.contact->low, 1e-12);
    }
    EXPECT_EQ(contacts, 4U);
  }
}

TEST(Process, WhatIsInTheWayIsNamedWithTheMoveAndTheAngle) {
  const auto failure = [](const std::vector<std::string>& changes) {
    return fmt::format("{}", fmt::join(simulate(aristo(changes), {.finds_ways = false}).refused, "; "));
  };
  const std::string in_the_way =
      failure({R"(machine.parts[6]={"name":"wall","box":{"from":[-160,-20,-360],"to":[-120,20,400]}})"});
  EXPECT_NE(in_the_way.find("from the side: to-storage base -149: after "), std::string::npos) << in_the_way;
  EXPECT_NE(in_the_way.find(" degrees the sphere touches machine/wall"), std::string::npos) << in_the_way;
  // Where the sphere passes, but the forearm does not.
  const std::string bar =
      failure({R"(machine.parts[6]={"name":"bar","box":{"from":[-330,-20,80],"to":[-290,20,110]}})"});
  EXPECT_NE(bar.find("Axis"), std::string::npos) << bar;
  EXPECT_NE(bar.find(" touches machine/bar"), std::string::npos) << bar;
  const std::string fast = simulate(aristo({"step=6"}), {.sphere_alone = true, .finds_ways = false}).refused.at(0);
  EXPECT_NE(fast.find("steps of 6 degrees pass over the contact at 148."), std::string::npos) << fast;
}

TEST(Process, ALimitOfAJointIsNamed) {
  Cell cell = read_cell(kAristo);
  cell.robot.joints[0].lower = -140;
  const Process process = simulate({cell, build_model(cell), covered_aristo()});
  EXPECT_NE(process.failure.find("to-storage base -149: joint base: -149 degrees are beyond its limits, -140 to 90"),
            std::string::npos)
      << process.failure;
}

TEST(Process, WhatWasDoneBeforeAFailureIsKept) {
  const Process process =
      simulate(aristo({R"(machine.parts[6]={"name":"lid","box":{"from":[-60,-60,50],"to":[60,60,60]}})"}),
               {.finds_ways = false});
  EXPECT_NE(process.failure.find("machine/lid"), std::string::npos) << process.failure;
  ASSERT_GE(process.moves.size(), 4U);  // up to the lid, which ends the shoulder's way down
  EXPECT_EQ(process.transfers.size(), 2U);
  EXPECT_GE(process.stops.size(), 1 + 3 + 149 + 38 + 66U);
  EXPECT_GE(process.stops.back().move + 1, process.moves.size());
}

}  // namespace
}  // namespace touchstone::cell

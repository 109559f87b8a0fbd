// SPDX-License-Identifier: GPL-3.0-or-later
// The whole process of the cell: what the captions say comes out, and every stop is what is promised of it.
#include "experiments/cell/simulation/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/cell/kinematics/simulated_path.h"
#include "experiments/cell/kinematics/solve_layout.h"
#include "robust/exact/exact.h"
#include "tests/experiments/cell/simulation/cells.h"

namespace touchstone::cell_simulation_tests {
namespace {

using cell::Phase;
using cell::Process;
using cell::StationSlot;
using cell::Until;

/// What a joint was moved by in these phases, in sum.
double net(const Process& process, cell::Moved joint, std::initializer_list<Phase> phases) {
  double sum = 0;
  for (const cell::Move& move : process.moves)
    if (move.joint == joint && std::ranges::find(phases, move.phase) != phases.end()) sum += move.degrees;
  return sum;
}

std::vector<std::pair<cell::Moved, double>> moves_to_machine(const Process& process) {
  std::vector<std::pair<cell::Moved, double>> moves;
  for (const cell::Move& move : process.moves)
    if (move.phase <= Phase::ToMachine) moves.emplace_back(move.joint, move.degrees);
  return moves;
}

bool touches(const Ball& ball, const scene::Faces& faces) {
  return std::ranges::any_of(faces.triangles,
                             [&](const Triangle& t) {
                               return exact::contact(ball, Polygon({t.a, t.b, t.c}));
                             }) ||
         std::ranges::any_of(faces.polygons, [&](const Polygon& p) { return exact::contact(ball, p); });
}

TEST(Process, TheCaptionsOfBothCaseStudiesComeOutToTheDegree) {
  using enum cell::Moved;
  const Process first = cell::simulate(aristo()), second = cell::simulate(aristo(kSecondCase));
  EXPECT_EQ(first.failure + second.failure, "");
  const std::vector<std::pair<cell::Moved, double>> one{
      {kElbow, -3}, {kBase, -149}, {kElbow, 38}, {kBase, 66}, {kShoulder, 28}};
  const std::vector<std::pair<cell::Moved, double>> two{{kElbow, 12}, {kBase, -183}, {kShoulder, 25}, {kShoulder, -11},
                                                        {kElbow, 23}, {kBase, 100},  {kShoulder, 14}};
  EXPECT_EQ(moves_to_machine(first), one);
  EXPECT_EQ(moves_to_machine(second), two);
}

// The same moves by the cell's faces and by the layout that was solved for, which knows of no more than the material.
TEST(Process, ItsMovesAreThoseOfTheLayoutsSimulatedPath) {
  const kinematics::Layout layout = kinematics::chosen_layout();
  for (std::size_t number = 0; number < kinematics::kCases.size(); ++number) {
    const auto path = kinematics::simulate(layout, layout.storage(number, kinematics::kCases[number].storage_angle));
    const Process process = cell::simulate(aristo(number == 0 ? std::vector<std::string>{} : kSecondCase));
    ASSERT_GE(process.moves.size(), path.moves.size());
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      EXPECT_EQ(process.moves[i].degrees, path.moves[i].degrees) << "case " << number + 1 << ", move " << i + 1;
      EXPECT_NEAR(process.moves[i].exact, path.moves[i].exact, 1e-9) << "case " << number + 1 << ", move " << i + 1;
    }
  }
}

// At 48 degrees and more the storage reaches into the machine.
TEST(Process, TheBaseTurnsAsTheCaptionsImplyForEveryAngleOfTheStorage) {
  for (int angle = -60; angle <= 60; angle += 4)
    for (const bool second : {false, true}) {
      const std::string at = "storage.angle=" + std::to_string(angle);
      const cell::Workcell workcell = aristo(second ? std::vector{kSecondCase[1], at} : std::vector{at});
      const Process process = cell::simulate(workcell);
      if (angle >= 48 && !process.failure.empty()) {
        EXPECT_NE(process.failure.find("machine/"), std::string::npos) << at;
        if (second || process.moves.back().phase < Phase::ToMachine) continue;
      } else {
        ASSERT_EQ(process.failure, "") << at;
      }
      EXPECT_EQ(net(process, cell::kBase, {Phase::ToStorage}), -150 + angle) << at;
      EXPECT_EQ(net(process, cell::kBase, {Phase::ToMachine}), 67 - angle) << at;
      EXPECT_EQ(net(process, cell::kElbow, {Phase::ToStorage, Phase::ToMachine}), 35) << at;
      EXPECT_EQ(net(process, cell::kShoulder, {Phase::ToStorage, Phase::ToMachine}), 28) << at;
    }
}

TEST(Process, ItEndsAtHomeWithTheMaterialBackInItsSlot) {
  for (const auto& changes : {std::vector<std::string>{},
                              kSecondCase,
                              {"material.slot=A"},
                              {"material.slot=C"},
                              {"storage.height=300"},
                              {"storage.radius=420"},
                              {"step=0.5"}}) {
    const cell::Workcell workcell = aristo(changes);
    const Process process = cell::simulate(workcell);
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
  const cell::Workcell workcell = aristo({"step=0.5"});
  const Process process = cell::simulate(workcell);
  for (std::size_t i = 1; i < process.stops.size(); ++i) {
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
    const cell::Workcell workcell = aristo(changes);
    const Process process = cell::simulate(workcell);
    std::size_t contacts = 0;
    for (std::size_t i = 1; i < process.stops.size(); ++i) {
      const cell::Stop& stop = process.stops[i];
      const cell::Move& move = process.moves.at(stop.move);
      EXPECT_FALSE(touches(stop.sphere, workcell.obstacles().faces)) << "stop " << i;
      if (!stop.target) continue;
      const scene::Faces& target = workcell.at(*stop.target).faces;
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
  const auto failure = [](const std::vector<std::string>& changes) { return cell::simulate(aristo(changes)).failure; };
  const std::string in_the_way =
      failure({R"(machine.parts[6]={"name":"wall","box":{"from":[-160,-20,-400],"to":[-120,20,400]}})"});
  EXPECT_NE(in_the_way.find("from the side: to-storage base -149: after 79.94 degrees the sphere touches machine/wall"),
            std::string::npos)
      << in_the_way;
  // Where the sphere passes, but the forearm does not.
  const std::string bar =
      failure({R"(machine.parts[6]={"name":"bar","box":{"from":[-400,-20,-30],"to":[-300,20,-10]}})"});
  EXPECT_NE(bar.find("comes within"), std::string::npos) << bar;
  EXPECT_NE(bar.find(" mm of machine/bar"), std::string::npos) << bar;
  const std::string fast = failure({"step=3"});
  EXPECT_NE(fast.find("steps of 3 degrees pass over the contact at 148.49"), std::string::npos) << fast;
}

TEST(Process, ALimitOfAJointIsNamed) {
  cell::Cell cell = cell::read_cell(kAristo);
  cell.robot.joints[0].lower = -140;
  const Process process = cell::simulate({cell, cell::build_model(cell), covered_aristo()});
  EXPECT_NE(process.failure.find("to-storage base -149: joint base: -149 degrees are beyond its limits, -140 to 90"),
            std::string::npos)
      << process.failure;
}

TEST(Process, WhatWasDoneBeforeAFailureIsKept) {
  const Process process =
      cell::simulate(aristo({R"(machine.parts[6]={"name":"lid","box":{"from":[-60,-60,50],"to":[60,60,60]}})"}));
  EXPECT_NE(process.failure.find("machine/lid"), std::string::npos) << process.failure;
  ASSERT_EQ(process.moves.size(), 2U);
  EXPECT_EQ(process.transfers.size(), 2U);
  EXPECT_EQ(process.stops.size(), 153U);
}

}  // namespace
}  // namespace touchstone::cell_simulation_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// The layout: both case studies as captioned, what they imply for every angle, and what flips a caption.
#include "experiments/thesis/cell/kinematics/layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/kinematics/layout_study.h"

namespace touchstone::kinematics {
namespace {

std::vector<double> degrees_of(const cell::Process& path) {
  std::vector<double> degrees;
  for (const cell::Move& move : path.moves) degrees.push_back(move.degrees);
  return degrees;
}

double net(const cell::Process& path, cell::Moved joint) {
  return path.turned(joint, cell::Phase::ToStorage) + path.turned(joint, cell::Phase::ToMachine);
}

// The captions of Figs 6.4 to 6.17 and 6.20 to 6.29, with the lift of 11 degrees that they leave out.
TEST(ChosenLayout, BringsOutTheCaptionedAnglesOfBothCases) {
  const Layout layout = chosen_layout();
  const cell::Process first = rehearse_case(layout, 0), second = rehearse_case(layout, 1);
  EXPECT_EQ(degrees_of(first), (std::vector<double>{-3, -149, 38, 66, 28})) << first.failure;
  EXPECT_EQ(degrees_of(second), (std::vector<double>{12, -183, 25, -11, 23, 100, 14})) << second.failure;
  EXPECT_EQ(difference(first, kCases[0]), "");
  EXPECT_EQ(difference(second, kCases[1]), "");
  ASSERT_EQ(first.moves.size(), 5U);
  EXPECT_EQ(first.moves[1].contact.value().feature.kind, Feature::Kind::Face);  // Fig 6.9: sphere and face
}

TEST(ChosenLayout, KeepsEveryRoundedAngleNearlyHalfADegreeFromTheNext) {
  const Layout layout = chosen_layout();
  for (std::size_t number = 0; number < kCases.size(); ++number)
    for (const cell::Move& move : rehearse_case(layout, number).moves) {
      EXPECT_GE(move.margin, 0.47);
      if (!move.contact) continue;
      EXPECT_LE(move.contact->high - move.contact->low, 1e-12);
      EXPECT_EQ(std::ceil(move.contact->high), std::abs(move.degrees));
      EXPECT_EQ(std::floor(move.contact->low), std::abs(move.degrees) - 1);
    }
}

TEST(ChosenLayout, HasOneStorageHeightAndALevelHand) {
  const Layout layout = chosen_layout();
  EXPECT_EQ(layout.storage_height[0], layout.storage_height[1]);
  EXPECT_EQ(layout.home.elevation, kChosenElevation);
  EXPECT_EQ(layout.coupling, Coupling::KeepsElevation);
  EXPECT_EQ(layout.hand, Hand::Level);
}

// With the forearm level at home the sphere passes the machine within what gripper and vice take up there: 45 mm and
// 20 mm, half of the part, at least. At the chosen elevation it does not.
TEST(ChosenLayout, LetsTheHandPassInFrontOfTheMachine) {
  const auto room = [](const Layout& layout) {
    const SphereArm arm(layout);
    return layout.machine_radius -
           std::max(arm.reach({0, 0.0 + kCases[0].elbow}).out, arm.reach({0, 0.0 + kCases[1].elbow}).out);
  };
  const Linkage level{Coupling::KeepsElevation, Hand::Level};
  const double lean = leans_of_one_height(level, 0).front();
  EXPECT_LT(room(solve_layout(level, {lean, 0}).value()), 45 + 20);
  EXPECT_GT(room(chosen_layout()), 45 + 30 + 16);
}

// 150 - theta clockwise, 67 - theta back, net elbow +35 and net shoulder +28: for every whole angle, both places.
TEST(ChosenLayout, PredictsTheBaseMovesAndTheNetAnglesAtTheMachine) {
  const Layout layout = chosen_layout();
  for (std::size_t place = 0; place < 2; ++place)
    for (int angle = -60; angle <= 60; ++angle) {
      const cell::Process path = rehearse(layout, layout.storage(place, angle));
      ASSERT_FALSE(path.cause) << angle << ": " << path.failure;
      EXPECT_EQ(path.turned(cell::kBase, cell::Phase::ToStorage), -(150 - angle)) << angle;
      EXPECT_EQ(path.turned(cell::kBase, cell::Phase::ToMachine), 67 - angle) << angle;
      EXPECT_EQ(net(path, cell::kElbow), 35) << angle;
      EXPECT_EQ(net(path, cell::kShoulder), 28) << angle;
    }
}

// The same net angles at the machine, whatever the storage's height: what its figures of other heights leave open.
TEST(ChosenLayout, PredictsTheNetAnglesForOtherHeightsOfTheStorage) {
  const Layout layout = chosen_layout();
  for (std::size_t place = 0; place < 2; ++place)
    for (const double raised : {-120.0, -37.0, 13.0, 88.0}) {
      Station storage = layout.storage(place, kCases[place].storage_angle);
      storage.height += raised;
      const cell::Process path = rehearse(layout, storage);
      ASSERT_FALSE(path.cause) << raised << ": " << path.failure;
      EXPECT_EQ(net(path, cell::kElbow), 35) << raised;
      EXPECT_EQ(net(path, cell::kShoulder), 28) << raised;
      EXPECT_EQ(net(path, cell::kBase), kMachineAzimuth) << raised;
    }
}

// Half a degree from the next: what moves an angle by more than that flips the caption, and is named.
TEST(Rehearsal, TellsWhichCaptionFlips) {
  Layout layout = chosen_layout();
  layout.machine_height += 5;
  EXPECT_EQ(difference(rehearse_case(layout, 0), kCases[0]), "move 3: elbow +39 where the caption says elbow +38");
  layout = chosen_layout();
  layout.gap += 8;
  EXPECT_NE(rehearse_case(layout, 0).refused.at(0).find(
                "from the side: to-storage base -149: the sphere does not touch the material"),
            std::string::npos);
  layout = chosen_layout();
  layout.clearance -= 4;
  EXPECT_EQ(difference(rehearse_case(layout, 1), kCases[1]),
            "move 4: shoulder -10 where the caption says shoulder -11");
}

TEST(Rehearsal, NamesWhatIsOutOfReach) {
  const Layout layout = chosen_layout();
  Station storage = layout.storage(1, -33);
  storage.radius = 2000;
  const cell::Process path = rehearse(layout, storage);
  EXPECT_EQ(path.cause, cell::FailureCause::OutOfReach);
  EXPECT_NE(path.failure.find("the upper face of the material is out of reach"), std::string::npos) << path.failure;
}

TEST(SolveLayout, BringsOutTheCaptionsFromOtherHomesToo) {
  std::size_t out = 0;
  for (const Linkage& linkage : {Linkage{Coupling::KeepsElevation, Hand::Level}, Linkage{Coupling::Serial, Hand::Level},
                                 Linkage{Coupling::KeepsElevation, Hand::Locked}})
    for (const double elevation : {-30.0, -20.0, -10.0})
      for (const double lean : leans_of_one_height(linkage, elevation)) {
        const auto layout = solve_layout(linkage, {lean, elevation});
        ASSERT_TRUE(layout.has_value());
        EXPECT_NEAR(layout->storage_height[0], layout->storage_height[1], 1e-6);
        for (std::size_t number = 0; number < kCases.size(); ++number)
          EXPECT_EQ(difference(rehearse_case(*layout, number), kCases[number]), "")
              << to_string(linkage.coupling) << ' ' << to_string(linkage.hand) << ' ' << lean << ' ' << elevation;
        ++out;
      }
  EXPECT_GE(out, 4U);
}

// The wrist stands at one height at the storage of both cases on the curves that follow from the lengths alone:
// sin(s0 + 12.5) = 0.7538 cos(e0 + 4.5), serial: sin(s0 + 12.5) = -0.5033 cos(e0 - 8).
TEST(Wrist, StandsAtOneHeightInBothCasesOnTheKnownCurves) {
  for (const Coupling coupling : kCouplings) {
    const bool keeps = coupling == Coupling::KeepsElevation;
    const double factor =
        kForearm / kUpperArm * (keeps ? workloads::sine(7.5) : -workloads::sine(5)) / workloads::sine(12.5);
    EXPECT_NEAR(factor, keeps ? 0.7538 : -0.5033, 5e-5);
    const Chain chain = aristo(coupling);
    for (int elevation = -40; elevation <= 40; elevation += 5) {
      const double lean =
          workloads::arc_sine(factor * workloads::cosine(keeps ? elevation + 4.5 : elevation - 8)) - 12.5;
      Angles first = aristo_pose(coupling, 0, {lean, 0.0 + elevation}), second = first;
      first[kElbow] -= 3;
      second[kElbow] += 12, second[kShoulder] += 25;
      EXPECT_NEAR(wrist(chain, first).z(), wrist(chain, second).z(), 1e-10) << elevation;
    }
  }
}

// The arm in its plane is the chain, seen from the side.
TEST(SphereArm, AgreesWithTheChain) {
  for (const Hand hand : kHands)
    for (const Coupling coupling : kCouplings) {
      Layout layout = chosen_layout();
      layout.coupling = coupling;
      layout.hand = hand;
      layout.home = {-11, 17};
      const SphereArm arm(layout);
      for (const double shoulder : {-10.0, 0.0, 30.0})
        for (const double elbow : {-20.0, 0.0, 35.0}) {
          Angles angles = home_pose(layout);
          angles[kShoulder] += shoulder, angles[kElbow] += elbow;
          const Eigen::Vector3d center = aristo(coupling, hand).place(angles, sphere_center(layout));
          const Reach reach = arm.reach({shoulder, elbow});
          EXPECT_NEAR(reach.out, center.x(), 1e-11);
          EXPECT_NEAR(reach.up, center.z(), 1e-11);
        }
    }
}

}  // namespace
}  // namespace touchstone::kinematics

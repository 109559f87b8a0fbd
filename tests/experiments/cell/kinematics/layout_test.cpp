// SPDX-License-Identifier: GPL-3.0-or-later
// The layout: both case studies as captioned, what they imply for every angle, and what flips a caption.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cell/kinematics/simulated_path.h"
#include "experiments/cell/kinematics/solve_layout.h"
#include "experiments/workloads/degrees.h"

namespace touchstone::cell_tests {
namespace {

using namespace kinematics;

SimulatedPath simulate_case(const Layout& layout, std::size_t number) {
  return simulate(layout, layout.storage(number, kCases[number].storage_angle));
}

std::vector<int> degrees_of(const SimulatedPath& path) {
  std::vector<int> degrees;
  for (const Move& move : path.moves) degrees.push_back(move.degrees);
  return degrees;
}

// The captions of Figs 6.4 to 6.17 and 6.20 to 6.29, with the lift of 11 degrees that they leave out.
TEST(ChosenLayout, BringsOutTheCaptionedAnglesOfBothCases) {
  const Layout layout = chosen_layout();
  const SimulatedPath first = simulate_case(layout, 0), second = simulate_case(layout, 1);
  EXPECT_EQ(degrees_of(first), (std::vector{-3, -149, 38, 66, 28})) << first.failure;
  EXPECT_EQ(degrees_of(second), (std::vector{12, -183, 25, -11, 23, 100, 14})) << second.failure;
  EXPECT_EQ(difference(first, kCases[0]), "");
  EXPECT_EQ(difference(second, kCases[1]), "");
  ASSERT_EQ(first.moves.size(), 5U);
  EXPECT_EQ(first.moves[1].contact.value().feature.kind, Feature::Kind::Face);  // Fig 6.9: sphere and face of material
}

TEST(ChosenLayout, KeepsEveryRoundedAngleNearlyHalfADegreeFromTheNext) {
  const Layout layout = chosen_layout();
  for (std::size_t number = 0; number < kCases.size(); ++number)
    for (const Move& move : simulate_case(layout, number).moves) {
      EXPECT_GE(move.margin, 0.48);
      if (!move.contact) continue;
      EXPECT_LE(move.contact->high - move.contact->low, 1e-12);
      EXPECT_EQ(std::ceil(move.contact->high), std::abs(move.degrees));
      EXPECT_EQ(std::floor(move.contact->low), std::abs(move.degrees) - 1);
    }
}

TEST(ChosenLayout, HasOneStorageHeightAndTheForearmOfTheTable) {
  const Layout layout = chosen_layout();
  EXPECT_EQ(layout.storage_height[0], layout.storage_height[1]);
  EXPECT_EQ(layout.home.elevation, 0);
  EXPECT_EQ(layout.coupling, Coupling::KeepsElevation);
}

// 150 - theta clockwise, 67 - theta back, net elbow +35 and net shoulder +28: for every whole angle, both places.
TEST(ChosenLayout, PredictsTheBaseMovesAndTheNetAnglesAtTheMachine) {
  const Layout layout = chosen_layout();
  for (std::size_t place = 0; place < 2; ++place)
    for (int angle = -60; angle <= 60; ++angle) {
      const SimulatedPath path = simulate(layout, layout.storage(place, angle));
      ASSERT_TRUE(path.complete()) << angle << ": " << path.failure;
      EXPECT_EQ(path.to_storage(kBase), -(150 - angle)) << angle;
      EXPECT_EQ(path.net(kBase) - path.to_storage(kBase), 67 - angle) << angle;
      EXPECT_EQ(path.net(kElbow), 35) << angle;
      EXPECT_EQ(path.net(kShoulder), 28) << angle;
    }
}

// The same net angles at the machine, whatever the storage's height: what its figures of other heights leave open.
TEST(ChosenLayout, PredictsTheNetAnglesForOtherHeightsOfTheStorage) {
  const Layout layout = chosen_layout();
  for (std::size_t place = 0; place < 2; ++place)
    for (const double raised : {-120.0, -37.0, 13.0, 88.0}) {
      Station storage = layout.storage(place, kCases[place].storage_angle);
      storage.height += raised;
      const SimulatedPath path = simulate(layout, storage);
      ASSERT_TRUE(path.complete()) << raised << ": " << path.failure;
      EXPECT_EQ(path.net(kElbow), 35) << raised;
      EXPECT_EQ(path.net(kShoulder), 28) << raised;
      EXPECT_EQ(path.net(kBase), kMachineAzimuth) << raised;
    }
}

// Half a degree from the next: what moves an angle by more than that flips the caption, and is named.
TEST(SimulatedPath, TellsWhichCaptionFlips) {
  Layout layout = chosen_layout();
  layout.machine_height += 5;
  EXPECT_EQ(difference(simulate_case(layout, 0), kCases[0]), "move 3: elbow +39 where the caption says elbow +38");
  layout = chosen_layout();
  layout.gap += 8;
  EXPECT_EQ(
      difference(simulate_case(layout, 0), kCases[0]),
      "from above: shoulder +66: the sphere touches nothing; from the side: base -149: the sphere touches nothing");
  layout = chosen_layout();
  layout.clearance -= 4;
  EXPECT_EQ(difference(simulate_case(layout, 1), kCases[1]),
            "move 4: shoulder -10 where the caption says shoulder -11");
}

TEST(SimulatedPath, NamesWhatIsInTheWayAndWhatIsOutOfReach) {
  const Layout layout = chosen_layout();
  Station storage = layout.storage(1, -33);
  storage.radius = 2000;
  EXPECT_EQ(simulate(layout, storage).failure,
            "from above: the upper face of the material is out of reach; "
            "from the side: the side of the material is out of reach");
  Layout blocked = layout;  // the machine's material stands where the sphere goes by
  blocked.machine_radius = layout.storage_radius[0];
  blocked.machine_height = layout.storage_height[0];
  const SimulatedPath path = simulate_case(blocked, 0);
  EXPECT_TRUE(path.failure.starts_with("from above: base -149: the sphere touches the material at the machine"))
      << path.failure;
}

// A ball so small that a step of the base passes over the side of the material.
TEST(SimulatedPath, NoticesThatStepsPassOverAContact) {
  Layout layout = chosen_layout();
  layout.gap -= layout.sphere_radius - 0.5;
  layout.sphere_radius = 0.5;
  EXPECT_TRUE(simulate_case(layout, 0).failure.find("steps of 1 degree pass over the contact") != std::string::npos)
      << simulate_case(layout, 0).failure;
}

TEST(SolveLayout, BringsOutTheCaptionsFromOtherHomesToo) {
  std::size_t out = 0;
  for (const Coupling coupling : kCouplings)
    for (const double elevation : {-20.0, 0.0, 20.0})
      for (const double lean : leans_of_one_height(coupling, elevation)) {
        const auto layout = solve_layout(coupling, {lean, elevation});
        ASSERT_TRUE(layout.has_value());
        EXPECT_NEAR(layout->storage_height[0], layout->storage_height[1], 1e-6);
        for (std::size_t number = 0; number < kCases.size(); ++number)
          EXPECT_EQ(difference(simulate_case(*layout, number), kCases[number]), "")
              << to_string(coupling) << ' ' << lean << ' ' << elevation;
        ++out;
      }
  EXPECT_GE(out, 6U);
}

// The wrist stands at one height at the storage of both cases on the curves that follow from the lengths alone:
// sin(s0 + 12.5) = 0.7538 cos(e0 + 4.5), serial: sin(s0 + 12.5) = -0.5033 cos(e0 - 8).
TEST(Aristo, HasItsWristAtOneHeightInBothCasesOnTheKnownCurves) {
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
  for (const Coupling coupling : kCouplings) {
    Layout layout = chosen_layout();
    layout.coupling = coupling;
    layout.home = {-11, 17};
    const SphereArm arm(layout);
    for (const double shoulder : {-10.0, 0.0, 30.0})
      for (const double elbow : {-20.0, 0.0, 35.0}) {
        Angles angles = home_pose(layout);
        angles[kShoulder] += shoulder, angles[kElbow] += elbow;
        const Eigen::Vector3d center = aristo(coupling).place(angles, sphere_center(layout));
        const Reach reach = arm.reach({shoulder, elbow});
        EXPECT_NEAR(reach.out, center.x(), 1e-11);
        EXPECT_NEAR(reach.up, center.z(), 1e-11);
        const auto back = arm.inverse(reach);
        ASSERT_TRUE(back.has_value());
        EXPECT_NEAR(arm.reach(*back).out, reach.out, 1e-9);
        EXPECT_NEAR(back->shoulder, shoulder, 1e-9);
      }
  }
}

}  // namespace
}  // namespace touchstone::cell_tests

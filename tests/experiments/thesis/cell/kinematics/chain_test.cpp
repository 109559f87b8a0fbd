// SPDX-License-Identifier: GPL-3.0-or-later
// The joint chain: the published lengths, couplings, arcs, limits, and back from a point to the angles.
#include "experiments/thesis/cell/kinematics/chain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/kinematics/aristo.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::kinematics {
namespace {

using run_tests::message_of;
using workloads::Random;

constexpr double kNear = 1e-11;  // mm

void expect_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const std::string& where = "") {
  EXPECT_LE((a - b).norm(), kNear) << where << ": " << a.transpose() << " and " << b.transpose();
}

/// Angles well within the limits of both couplings.
Angles random_angles(Random& random) {
  const auto between = [&](double low, double high) { return low + (high - low) * random.unit(); };
  return {between(-200, 60), between(-40, 40), between(-40, 40), between(-90, 90), between(-90, 90), between(-90, 90)};
}

// The table of [ghaayathri]: wrist at (375, 0, 622), flange at (375, 0, 559), the hand down.
TEST(Aristo, StandsAtHomeWhereTheTableSays) {
  for (const Coupling coupling : kCouplings) {
    const Chain chain = aristo(coupling);
    const Angles home(6, 0.0);
    EXPECT_EQ(wrist(chain, home), Eigen::Vector3d(375, 0, 622));
    EXPECT_EQ(chain.frames(home).back().translation, Eigen::Vector3d(375, 0, 559));
    EXPECT_EQ(chain.place(home, {0, 0, 100}), Eigen::Vector3d(375, 0, 459));
  }
}

TEST(Aristo, TurnsEveryJointTheWayItsCommandSays) {
  const Chain chain = aristo(Coupling::KeepsElevation);
  const auto flange = [&](std::size_t joint, double degrees) {
    Angles angles(6, 0.0);
    angles[joint] = degrees;
    return chain.frames(angles).back().translation;
  };
  expect_near(flange(kBase, 90), {0, 375, 559});
  expect_near(flange(kShoulder, 90), {675, 0, 259});
  expect_near(flange(kElbow, 90), {63, 0, 997});
  expect_near(flange(kWristPitch, 90), {438, 0, 622});
  expect_near(aristo(Coupling::Serial).frames({0, 90, 0, 0, 0, 0}).back().translation, {237, 0, -53});
}

TEST(Aristo, KeepsTheForearmsElevationOrDoesNot) {
  for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 93);
    Angles before = random_angles(random), after = before;
    after[kShoulder] += 25;
    for (const Coupling coupling : kCouplings) {
      const Chain chain = aristo(coupling);
      const double change =
          (chain.frames(before).back().rotation - chain.frames(after).back().rotation).cwiseAbs().maxCoeff();
      if (coupling == Coupling::KeepsElevation) {
        EXPECT_LE(change, 1e-14) << "sample " << index;
      } else {
        EXPECT_GE(change, 0.1) << "sample " << index;
      }
    }
  }
}

// A level hand is not turned by shoulder and elbow, wherever the arm is; by the base and its own joints it is.
TEST(Aristo, KeepsALevelHandAsItIs) {
  for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 97);
    Angles before = random_angles(random), after = before;
    before[kWristRoll] = after[kWristRoll] = 0;
    after[kShoulder] += 25, after[kElbow] -= 40;
    for (const Coupling coupling : kCouplings) {
      const Chain chain = aristo(coupling, Hand::Level);
      EXPECT_LE((chain.frames(before).back().rotation - chain.frames(after).back().rotation).cwiseAbs().maxCoeff(),
                1e-14)
          << "sample " << index;
      EXPECT_EQ(chain.compensating(kElbow), std::size_t{kWristPitch});
    }
  }
}

// Moving a joint step by step and going along its arc is the same: for the driver too, whose arc is about another axis.
TEST(Chain, GoesAlongTheArcThatItNames) {
  const Eigen::Vector3d point(7, -3, 85);
  for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 94);
    Angles angles = random_angles(random);
    for (const auto& [coupling, hand] :
         {std::pair(Coupling::KeepsElevation, Hand::Locked), std::pair(Coupling::Serial, Hand::Locked),
          std::pair(Coupling::KeepsElevation, Hand::Level), std::pair(Coupling::Serial, Hand::Level)}) {
      const Chain chain = aristo(coupling, hand);
      if (hand == Hand::Level) {  // the wrist's pitch is parallel to the elbow, and within its limits
        angles[kWristRoll] = 0;
        angles[kWristPitch] = angles[kElbow] - (coupling == Coupling::Serial ? angles[kShoulder] : 0);
      }
      for (std::size_t joint = 0; joint < (hand == Hand::Level ? 3 : 6); ++joint)
        for (const double move : {20.0, -20.0}) {
          const Arc arc = chain.arc(angles, joint, move, point);
          EXPECT_EQ(arc.degrees, 20);
          for (const double part : {0.0, 0.25, 1.0}) {
            Angles moved = angles;
            moved[joint] += part * move;
            expect_near(point_at(arc, part * 20), chain.place(moved, point), "sample " + std::to_string(index));
          }
        }
    }
  }
}

TEST(Chain, NamesTheJointThatIsBeyondItsLimits) {
  const Chain chain = aristo(Coupling::KeepsElevation);
  const auto message = [&](const Angles& angles) {
    return message_of<std::exception>([&] { chain.require_reachable(angles); });
  };
  EXPECT_EQ(message({0, 0, 0, 0, 0, 0}), "");
  EXPECT_EQ(message({-271, 0, 0, 0, 0, 0}), "joint base: -271 degrees are beyond its limits, -270 to 90");
  EXPECT_EQ(message({0, 0, 0, 0, NAN, 0}), "joint wrist pitch: nan degrees are beyond its limits, -120 to 120");
  // The elbow makes up for the shoulder.
  EXPECT_EQ(message({0, 60, 70, 0, 0, 0}), "joint elbow: 130 degrees are beyond its limits, -120 to 120");
  EXPECT_NO_THROW(aristo(Coupling::Serial).require_reachable({0, 60, 70, 0, 0, 0}));
  EXPECT_EQ(message({0, 0}), "2 angles for 6 joints");
  EXPECT_EQ(message_of<std::exception>([&] {
              (void)chain.arc({0, 0, 0, 0, 0, 0}, kBase, 91, {0, 0, 0});
            }),
            "joint base: 91 degrees are beyond its limits, -270 to 90");
}

TEST(Chain, HasRoomUpToTheFirstLimit) {
  const Angles angles{0, 10, 50, 0, 0, 0};
  const Chain keeps = aristo(Coupling::KeepsElevation), serial = aristo(Coupling::Serial);
  EXPECT_EQ(keeps.room(angles, kShoulder, true), 60);  // then the elbow is at 120
  EXPECT_EQ(keeps.room(angles, kShoulder, false), 100);
  EXPECT_EQ(serial.room(angles, kShoulder, true), 80);
  EXPECT_EQ(keeps.room(angles, kElbow, true), 60);
  EXPECT_EQ(serial.room(angles, kElbow, true), 70);
}

TEST(Chain, RefusesWhatIsNoChain) {
  const Joint good{"first", {}, {0, 0, 1}, -90, 90};
  Joint across = good, backwards = good, crooked = good;
  across.name = "second", across.axis = {1, 0, 0};
  backwards.lowest = 91;
  crooked.axis = {0, 0, 2};
  const auto message = [](std::vector<Joint> joints, const std::vector<Compensation>& compensations) {
    return message_of<std::exception>([&] { Chain(std::move(joints), {}, compensations); });
  };
  EXPECT_EQ(message({good, good}, {{0, 1}}), "");
  EXPECT_EQ(message({good, across, good}, {{0, 2}}), "");
  EXPECT_EQ(message({good, across}, {{0, 1}}), "joint second: it is to make up for a joint that is not parallel to it");
  EXPECT_EQ(message({good}, {{0, 1}}), "joint first: no joint comes behind it to make up for its turning");
  EXPECT_EQ(message({good, good}, {{1, 0}}), "joint first: no joint comes behind it to make up for its turning");
  EXPECT_EQ(message({good, good, good}, {{0, 1}, {0, 2}}), "joint first: two joints are to make up for its turning");
  EXPECT_EQ(message({good}, {{1, 2}}), "the driver is not a joint");
  EXPECT_EQ(message({backwards}, {}), "joint first: its lowest angle is above its highest");
  EXPECT_EQ(message({crooked}, {}), "joint first: its axis is not of length 1");
}

/// The commands that bring the wrist to a place, with the base facing it.
std::vector<Angles> inverse(Coupling coupling, const Eigen::Vector3d& wrist) {
  std::vector<Angles> solutions;
  for (const LinkAngles& arm :
       TwoLinks{kUpperArm, kForearm}.inverse({wrist.head<2>().norm(), wrist.z() - kShoulderHeight}))
    solutions.push_back(aristo_pose(coupling, workloads::arc_tangent(wrist.y(), wrist.x()), arm));
  return solutions;
}

TEST(Inverse, FindsTheAnglesOfAPoseAndTheOtherElbow) {
  for (std::uint64_t index = 0; index < 3 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 95);
    Angles angles = random_angles(random);
    angles[kElbow] = -30 + 100 * random.unit();
    for (const Coupling coupling : kCouplings) {
      const Chain chain = aristo(coupling);
      const Eigen::Vector3d target = wrist(chain, angles);
      const Angles in_plane{0, angles[kShoulder], angles[kElbow], 0, 0, 0};
      if (wrist(chain, in_plane).x() < 1) continue;  // behind the axis: the base would face the other way
      const auto solutions = inverse(coupling, target);
      ASSERT_EQ(solutions.size(), 2U) << "sample " << index;
      bool found = false;
      for (const Angles& solution : solutions) {
        EXPECT_LE((wrist(chain, solution) - target).norm(), 1e-9) << "sample " << index;
        found = found || (std::abs(solution[kShoulder] - angles[kShoulder]) < 1e-6 &&
                          std::abs(solution[kElbow] - angles[kElbow]) < 1e-6 &&
                          std::abs(std::remainder(solution[kBase] - angles[kBase], 360)) < 1e-6);
      }
      EXPECT_TRUE(found) << "sample " << index;
      const auto elbow_height = [&](const Angles& a) { return chain.frames(a)[kElbow].translation.z(); };
      EXPECT_GT(elbow_height(solutions[0]), elbow_height(solutions[1])) << "sample " << index;
    }
  }
}

TEST(Inverse, HasOneSolutionForTheStraightArmAndNoneBeyond) {
  EXPECT_EQ(inverse(Coupling::Serial, {675, 0, 322}).size(), 1U);
  EXPECT_TRUE(inverse(Coupling::Serial, {675.001, 0, 322}).empty());
  EXPECT_TRUE(inverse(Coupling::Serial, {50, 0, 322}).empty());
  EXPECT_TRUE(inverse(Coupling::Serial, {0, 0, 322}).empty());
}

}  // namespace
}  // namespace touchstone::kinematics

// SPDX-License-Identifier: GPL-3.0-or-later
// The bridge from a cell file's robot to the chain that is simulated.
#include "experiments/thesis/cell/simulation/arm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "experiments/cases/workloads/random.h"
#include "experiments/thesis/cell/kinematics/aristo.h"
#include "experiments/thesis/cell/kinematics/layout.h"
#include "experiments/thesis/cell/model/cell_entry.h"
#include "tests/experiments/support/message_of.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

using kinematics::Angles;
using run_tests::isometry;

/// Where the links are by the robot's own description, couplings included.
std::vector<Eigen::Isometry3d> described(const Robot& robot, const Angles& commanded) {
  std::vector<double> turns(robot.joints.size(), 0);
  std::vector<double> by_joint(robot.joints.size(), 0);
  for (std::size_t i = 0, next = 0; i < robot.joints.size(); ++i)
    if (robot.joints[i].kind == Joint::Kind::Revolute) turns[i] = by_joint[i] = commanded[next++];
  for (const Coupling& coupling : robot.couplings) turns[coupling.joint] += coupling.factor * by_joint[coupling.leader];
  return run_tests::links_at(robot, turns);
}

Angles random_angles(std::uint64_t n) {
  workloads::Random random(2026, n);
  Angles angles;
  for (int i = 0; i < 6; ++i) angles.push_back(between(random, -90, 90));
  return angles;
}

TEST(Arm, ItsLinksStandWhereTheRobotsDescriptionPutsThem) {
  Cell cell = read_cell(kAristo);
  cell.robot.base.translation.z() = 37;
  const Arm arm = arm_of(cell);
  for (std::uint64_t n = 0; n < 50; ++n) {
    const Angles angles = random_angles(n);
    const auto expected = described(cell.robot, angles);
    const auto poses = arm.link_poses(angles);
    ASSERT_EQ(poses.size(), expected.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
      EXPECT_TRUE(isometry(poses[i]).isApprox(expected[i], 1e-12)) << "link " << i << " of sample " << n;
    const Eigen::Vector3d center = expected.back() * cell.gripper.sphere.center;
    EXPECT_LT((arm.sphere_at(angles).center - center).norm(), 1e-10) << n;
  }
}

TEST(Arm, AFixedJointIsPartOfWhatItsLinkMovesWith) {
  Cell cell = read_cell(kAristo);
  cell.robot.joints[3].kind = Joint::Kind::Fixed;
  const Arm arm = arm_of(cell);
  ASSERT_EQ(arm.home.size(), 5U);
  const Angles angles{10, 20, -30, 40, 50};
  const auto expected = described(cell.robot, angles);
  const auto poses = arm.link_poses(angles);
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(isometry(poses[i]).isApprox(expected[i], 1e-12)) << i;
}

// The cell file and the layout that the captions were solved for are two descriptions of one arm.
TEST(Arm, TheCellsArmHoldsItsSphereWhereTheChosenLayoutDoes) {
  const Arm arm = arm_of(read_cell(kAristo));
  const kinematics::Layout layout = kinematics::chosen_layout();
  const kinematics::Chain chain = kinematics::aristo(layout.coupling, layout.hand);
  EXPECT_EQ(arm.home, kinematics::home_pose(layout));
  for (std::uint64_t n = 0; n < 50; ++n) {
    const Angles angles = random_angles(n);
    EXPECT_LT((arm.sphere_at(angles).center - chain.place(angles, kinematics::sphere_center(layout))).norm(), 1e-10);
  }
}

TEST(Arm, InverseBringsTheSphereToThePoint) {
  for (const auto& [coupled, beside] : {std::pair{true, 0.0}, {false, 0.0}, {true, 120.0}, {false, -60.0}}) {
    Cell cell = read_cell(kAristo);
    if (!coupled) cell.robot.couplings.clear();
    cell.gripper.sphere.center.y() = beside;
    const Arm arm = arm_of(cell);
    const PlanarArm plane(cell, arm);
    for (std::uint64_t n = 0; n < 50; ++n) {
      workloads::Random random(7, n);
      const kinematics::Reach point{between(random, 250, 550), between(random, 200, 600)};
      const double azimuth = between(random, -180, 180);
      const auto commands = plane.inverse(point);
      ASSERT_TRUE(commands) << n;
      Angles angles = arm.home;
      angles[kBase] = plane.base(plane.facing(azimuth, point.out));
      angles[kShoulder] = commands->shoulder;
      angles[kElbow] = commands->elbow;
      const Eigen::Vector3d at = arm.sphere_at(angles).center;
      const double a = azimuth * std::numbers::pi / 180;
      EXPECT_LT((at - Eigen::Vector3d(point.out * std::cos(a), point.out * std::sin(a), point.up)).norm(), 1e-8) << n;
    }
    EXPECT_EQ(std::abs(plane.beside()), std::abs(beside));
    EXPECT_FALSE(plane.inverse({2000, 0}));
    EXPECT_FALSE(plane.inverse({std::abs(beside) - 1, 400}));
  }
}

TEST(Arm, RefusesWhatWouldNotMoveOnArcs) {
  const auto fault = [](auto change) {
    Cell cell = read_cell(kAristo);
    change(cell);
    const auto put_together = [&] {
      const Arm arm = arm_of(cell);
      const PlanarArm plane(cell, arm);
    };
    return run_tests::after_file(kAristo, run_tests::message_of<BadCell>(put_together));
  };
  EXPECT_EQ(fault([](Cell&) {}), "");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings[0].factor = 0.5; }),
            "robot.coupling[0]: elbow is to undo the turning of shoulder, but its factor is 0.5, not 1");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings[0].leader = 0; }),
            "robot.coupling[0]: elbow is to undo the turning of base, but is not parallel to it at home");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings[1].joint = 0; }),
            "robot.coupling[1]: base is to undo the turning of elbow, but does not come behind it");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings.push_back(c.robot.couplings[0]); }),
            "robot.coupling[2]: elbow is to undo the turning of shoulder, but another joint does so already");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings.erase(c.robot.couplings.begin()); }),
            "robot.coupling: the turning of only one of shoulder and elbow is undone behind the elbow");
  EXPECT_EQ(fault([](Cell& c) { c.robot.couplings.pop_back(); }), "");  // a locked wrist
  EXPECT_EQ(fault([](Cell& c) {
              c.robot.joints[1].axis = {1, 0, 0};
              c.robot.couplings.clear();
            }),
            "robot.home: the second and third joint do not turn about y at home");
  EXPECT_EQ(fault([](Cell& c) { c.robot.joints[0].home = 180; }),
            "robot.home: at home the sphere's centre is at (-488.958, 0, 295.848), not in front of the base");
}

}  // namespace
}  // namespace touchstone::cell

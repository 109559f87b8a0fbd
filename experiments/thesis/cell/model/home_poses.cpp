// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/home_poses.h"

#include "experiments/cases/workloads/degrees.h"

namespace touchstone::cell {

Pose within(const Pose& outer, const Pose& pose) { return {outer.rotation * pose.rotation, outer * pose.translation}; }

Pose inverse(const Pose& pose) {
  const Eigen::Matrix3d back = pose.rotation.transpose();
  return {back, -(back * pose.translation)};
}

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees) {
  const double c = workloads::cosine(degrees), s = workloads::sine(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return c * Eigen::Matrix3d::Identity() + s * cross + (1 - c) * axis * axis.transpose();
}

double angle_at_home(const Robot& robot, std::size_t joint) {
  double angle = robot.joints[joint].home;
  for (const Coupling& coupling : robot.couplings)
    if (coupling.joint == joint) angle += coupling.factor * robot.joints[coupling.leader].home;
  return angle;
}

std::vector<Pose> home_poses(const Robot& robot) {
  std::vector<Pose> poses{robot.base};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    poses.push_back(within(poses.back(), joint.origin));
    if (joint.kind == Joint::Kind::Revolute)
      poses.back().rotation *= rotation_about(joint.axis, angle_at_home(robot, i));
  }
  return poses;
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/cell.h"

#include <stdexcept>
#include <vector>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/model/poses.h"

namespace touchstone::cell {

Label label_of(const std::map<std::string, Label>& labels, const std::string& path) {
  for (std::size_t length = path.size(); length > 0; --length) {
    if (length < path.size() && path[length] != '.' && path[length] != '[') continue;
    if (const auto found = labels.find(path.substr(0, length)); found != labels.end()) return found->second;
  }
  throw std::out_of_range("nothing is said of where " + path + " comes from");
}

std::vector<Part> parts_of(const Gripper& gripper) {
  std::vector<Part> parts = gripper.parts;
  if (gripper.fingers) parts.insert(parts.end(), gripper.fingers->parts.begin(), gripper.fingers->parts.end());
  return parts;
}

Pose pose_of(const Station& station) {
  const auto rotation = [](double degrees) {
    const double c = workloads::cosine(degrees), s = workloads::sine(degrees);
    Eigen::Matrix3d matrix;
    matrix << c, -s, 0, s, c, 0, 0, 0, 1;
    return matrix;
  };
  const Eigen::Matrix3d outward = rotation(station.azimuth());
  return {station.turn == 0 ? outward : rotation(station.azimuth() + station.turn),
          outward.col(0) * station.radius + Eigen::Vector3d(0, 0, station.height)};
}

Eigen::Vector2d turned(const Station& station, const Eigen::Vector2d& direction) {
  const double c = workloads::cosine(station.turn), s = workloads::sine(station.turn);
  return {c * direction.x() - s * direction.y(), s * direction.x() + c * direction.y()};
}

Eigen::Vector2d in_plan(const Station& station, const Eigen::Vector2d& point) {
  return Eigen::Vector2d(station.radius, 0) + turned(station, point);
}

Solid stand_of(const Station& station) {
  const Station::Stand& stand = station.stand.value();
  return {Box{{stand.lower.x(), stand.lower.y(), -station.height}, {stand.upper.x(), stand.upper.y(), stand.top}}};
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

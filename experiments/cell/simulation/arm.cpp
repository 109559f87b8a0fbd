// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/simulation/arm.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

#include "experiments/cell/model/cell_entry.h"
#include "experiments/workloads/degrees.h"

namespace touchstone::cell {
namespace {

[[noreturn]] void bad(const Cell& cell, const char* key, const std::string& reason) {
  throw BadCell(fmt::format("{}: {}: {}", cell.file.string(), key, reason));
}

/// Returns the pose of a frame that is at `pose` in a frame at `outer`.
Pose within(const Pose& outer, const Pose& pose) {
  return {outer.rotation * pose.rotation, outer.rotation * pose.translation + outer.translation};
}

/// The driver of the chain, whose joints have these places in Robot::joints.
std::optional<std::size_t> driver_of(const Cell& cell, const std::vector<kinematics::Joint>& joints,
                                     const std::vector<std::size_t>& places) {
  const auto& couplings = cell.robot.couplings;
  if (couplings.empty()) return std::nullopt;
  const Coupling& only = couplings.front();
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if (places[i] != only.leader || places[i + 1] != only.joint || couplings.size() > 1) continue;
    const Eigen::Vector3d axis = joints[i + 1].origin.rotation * joints[i + 1].axis;
    if (axis == -only.factor * joints[i].axis && std::abs(only.factor) == 1) return i;
  }
  bad(cell, "robot.coupling", "only one is simulated: of a joint with the next, parallel one, whose turning it undoes");
}

}  // namespace

Ball Arm::sphere_at(const kinematics::Angles& commanded) const {
  return {chain.place(commanded, sphere.center), sphere.radius};
}

std::vector<Pose> Arm::link_poses(const kinematics::Angles& commanded) const {
  const std::vector<Pose> frames = chain.frames(commanded);
  std::vector<Pose> poses;
  for (const Carried& link : links) poses.push_back(link.frame ? within(frames[*link.frame], link.pose) : link.pose);
  return poses;
}

Arm arm_of(const Cell& cell) {
  const Robot& robot = cell.robot;
  std::vector<kinematics::Joint> joints;
  std::vector<std::size_t> places;
  kinematics::Angles home;
  std::vector<Arm::Carried> links{{std::nullopt, robot.base}};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    const Arm::Carried& last = links.back();
    const Pose origin = within(last.pose, joint.origin);
    if (joint.kind == Joint::Kind::Fixed) {
      links.push_back({last.frame, origin});
      continue;
    }
    links.push_back({joints.size(), Pose{}});
    joints.push_back({joint.name, origin, joint.axis.normalized(), joint.lower, joint.upper});
    places.push_back(i);
    home.push_back(joint.home);
  }
  if (joints.size() <= kElbow) bad(cell, "robot.urdf", "fewer than three joints turn");
  const auto driver = driver_of(cell, joints, places);
  const Pose flange = links.back().pose;
  return {{std::move(joints), flange, driver}, std::move(home), cell.gripper.sphere, std::move(links)};
}

PlanarArm::PlanarArm(const Cell& cell, const Arm& arm) {
  const auto frames = arm.chain.frames(arm.home);
  const auto axis = [&](Moved joint) -> Eigen::Vector3d {
    return frames[joint].rotation * arm.chain.joints()[joint].axis;
  };
  const Eigen::Vector3d at = frames[kShoulder].translation, elbow = frames[kElbow].translation,
                        center = arm.sphere_at(arm.home).center;
  const double near = 1e-9 * (center - at).norm();
  const auto require = [&](bool holds, const std::string& otherwise) {
    if (!holds) bad(cell, "robot.urdf", otherwise);
  };
  const auto along = [&](Moved joint, int coordinate) {
    return std::abs(std::abs(axis(joint)[coordinate]) - 1) < 1e-9;
  };
  require(along(kBase, 2), "the first joint does not turn about z");
  require(along(kShoulder, 1) && along(kElbow, 1), "the second and third joint do not turn about y at home");
  require(std::abs(center.y()) <= near && center.x() > 0,
          fmt::format("at home the sphere's centre is at ({:g}, {:g}, {:g}), not over the positive x axis", center.x(),
                      center.y(), center.z()));

  home_base_ = arm.home[kBase];
  base_sense_ = axis(kBase).z() > 0 ? 1 : -1;
  home_ = {arm.home[kShoulder], arm.home[kElbow]};
  shoulder_sense_ = axis(kShoulder).y() > 0 ? 1 : -1;
  elbow_sense_ = axis(kElbow).y() > 0 ? -1 : 1;
  makes_up_ = !cell.robot.couplings.empty();
  shoulder_ = {at.x(), at.z()};
  const Eigen::Vector3d first = elbow - at, second = center - elbow;
  links_ = {first.norm(), second.norm()};
  home_angles_ = {workloads::arc_tangent(first.x(), first.z()), workloads::arc_tangent(second.z(), second.x())};
}

std::optional<PlanarArm::Commands> PlanarArm::inverse(const kinematics::Reach& center) const {
  std::optional<Commands> nearest;
  const auto away = [&](const Commands& c) {
    return std::abs(c.shoulder - home_.shoulder) + std::abs(c.elbow - home_.elbow);
  };
  for (const kinematics::LinkAngles& angles : links_.inverse({center.out - shoulder_.out, center.up - shoulder_.up})) {
    const double lean = std::remainder(angles.lean - home_angles_.lean, 360);
    const double carried = makes_up_ ? 0 : lean;
    const double raised = std::remainder(angles.elevation - home_angles_.elevation + carried, 360);
    const Commands commands{home_.shoulder + shoulder_sense_ * lean, home_.elbow + elbow_sense_ * raised};
    if (!nearest || away(commands) < away(*nearest)) nearest = commands;
  }
  return nearest;
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/arm.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

[[noreturn]] void bad(const Cell& cell, const std::string& key, const std::string& reason) {
  throw BadCell(fmt::format("{}: {}.{}: {}", cell.file.string(), cell.robot.key, key, reason));
}

/// The compensations of joints that have these places in Robot::joints, by the couplings.
std::vector<kinematics::Compensation> compensations_of(const Cell& cell, const kinematics::Chain& free,
                                                       const kinematics::Angles& home,
                                                       const std::vector<std::size_t>& places) {
  std::vector<kinematics::Compensation> all;
  const auto& couplings = cell.robot.couplings;
  const std::vector<Pose> frames = free.frames(home);
  const auto axis = [&](std::size_t i) -> Eigen::Vector3d { return frames[i].rotation * free.joints()[i].axis; };
  const auto index = [&](std::size_t joint) {
    return static_cast<std::size_t>(std::ranges::find(places, joint) - places.begin());
  };
  const auto follows = [&](std::size_t i) {
    return std::ranges::any_of(couplings, [&](const Coupling& c) { return c.joint == places[i]; });
  };
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const std::size_t driver = index(couplings[k].leader), joint = index(couplings[k].joint);
    const auto refuse = [&](const std::string& why) {
      bad(cell, fmt::format("coupling[{}]", k),
          fmt::format("{} is to undo the turning of {}, but {}", free.joints()[joint].name, free.joints()[driver].name,
                      why));
    };
    if (driver >= joint) refuse("does not come behind it");
    const auto parallel = [&](std::size_t i) { return axis(i).cross(axis(driver)).norm() <= 1e-12; };
    if (!parallel(joint)) refuse("is not parallel to it at home");
    if (const double undoing = axis(joint).dot(axis(driver)) > 0 ? -1 : 1; couplings[k].factor != undoing)
      refuse(fmt::format("its factor is {:g}, not {:g}", couplings[k].factor, undoing));
    for (std::size_t i = driver + 1; i < joint; ++i)
      if ((i <= kElbow || follows(i)) && !parallel(i))
        refuse(fmt::format("{} moves between them and is not parallel to them", free.joints()[i].name));
    for (const kinematics::Compensation& other : all)
      if (other.driver == driver) refuse("another joint does so already");
    all.push_back({driver, joint});
  }
  return all;
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
  std::vector<double> speeds, accelerations;
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
    speeds.push_back(joint.speed);
    accelerations.push_back(joint.acceleration);
  }
  if (joints.size() <= kElbow) bad(cell, "urdf", "fewer than three joints turn");
  const Pose flange = links.back().pose;
  const auto compensations = compensations_of(cell, {joints, flange}, home, places);
  return {{std::move(joints), flange, compensations, home},
          home,
          cell.gripper.sphere,
          std::move(links),
          std::move(speeds),
          std::move(accelerations)};
}

PlanarArm::PlanarArm(const Cell& cell, const Arm& arm) {
  const auto frames = arm.chain.frames(arm.home);
  const auto axis = [&](Moved joint) -> Eigen::Vector3d {
    return frames[joint].rotation * arm.chain.joints()[joint].axis;
  };
  const Eigen::Vector3d at = frames[kShoulder].translation, elbow = frames[kElbow].translation,
                        center = arm.sphere_at(arm.home).center;
  const double near = 1e-9 * (center - at).norm();
  const auto require = [&](bool holds, const std::string& key, const std::string& otherwise) {
    if (!holds) bad(cell, key, otherwise);
  };
  const auto along = [&](Moved joint, int coordinate) {
    return std::abs(std::abs(axis(joint)[coordinate]) - 1) < 1e-9;
  };
  require(along(kBase, 2), "urdf", "the first joint does not turn about z");
  require(along(kShoulder, 1) && along(kElbow, 1), "home", "the second and third joint do not turn about y at home");
  require(center.x() > 0, "home",
          fmt::format("at home the sphere's centre is at ({:g}, {:g}, {:g}), not in front of the base", center.x(),
                      center.y(), center.z()));

  beside_ = std::abs(center.y()) <= near ? 0 : center.y();
  home_base_ = arm.home[kBase];
  base_sense_ = axis(kBase).z() > 0 ? 1 : -1;
  home_ = {arm.home[kShoulder], arm.home[kElbow]};
  shoulder_sense_ = axis(kShoulder).y() > 0 ? 1 : -1;
  elbow_sense_ = axis(kElbow).y() > 0 ? -1 : 1;
  const auto by_shoulder = arm.chain.compensating(kShoulder), by_elbow = arm.chain.compensating(kElbow);
  makes_up_ = by_shoulder == std::size_t{kElbow};
  keeps_level_ = by_elbow.has_value();
  const Eigen::Vector3d wrist = by_elbow ? frames[*by_elbow].translation : center;
  if (by_elbow ? !by_shoulder : by_shoulder && !makes_up_)
    bad(cell, "coupling", "the turning of only one of shoulder and elbow is undone behind the elbow");
  shoulder_ = {at.x(), at.z()};
  hand_ = {center.x() - wrist.x(), center.z() - wrist.z()};
  const auto in_plane = [](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return Eigen::Vector3d(to.x() - from.x(), 0, to.z() - from.z());
  };
  const Eigen::Vector3d first = in_plane(at, elbow), second = in_plane(elbow, wrist);
  links_ = {first.norm(), second.norm()};
  home_angles_ = {workloads::arc_tangent(first.x(), first.z()), workloads::arc_tangent(second.z(), second.x())};
}

double PlanarArm::furthest() const {
  const double ahead = std::abs(shoulder_.out) + links_.first + links_.second + std::abs(hand_.out);
  return std::sqrt(ahead * ahead + beside_ * beside_);
}

/// How far ahead of the base's axis the centre is at a distance from it.
double PlanarArm::along(double out) const { return std::sqrt(std::max(0.0, out * out - beside_ * beside_)); }

double PlanarArm::facing(double azimuth, double out) const {
  return azimuth - workloads::arc_tangent(beside_, along(out));
}

std::optional<PlanarArm::Commands> PlanarArm::inverse(const kinematics::Reach& center) const {
  if (center.out < std::abs(beside_)) return std::nullopt;
  std::optional<Commands> nearest;
  const auto away = [&](const Commands& c) {
    return std::abs(c.shoulder - home_.shoulder) + std::abs(c.elbow - home_.elbow);
  };
  for (const kinematics::LinkAngles& angles :
       links_.inverse({along(center.out) - shoulder_.out - hand_.out, center.up - shoulder_.up - hand_.up})) {
    const double lean = std::remainder(angles.lean - home_angles_.lean, 360);
    const double carried = makes_up_ ? 0 : lean;  // else the shoulder turns the second link
    const double raised = std::remainder(angles.elevation - home_angles_.elevation + carried, 360);
    const Commands commands{home_.shoulder + shoulder_sense_ * lean, home_.elbow + elbow_sense_ * raised};
    if (!nearest || away(commands) < away(*nearest)) nearest = commands;
  }
  return nearest;
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/chain.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "experiments/cell/kinematics/degrees.h"

namespace touchstone::cell {
namespace {

/// From a link's frame to that of the one before it.
Pose link(const Joint& joint, double theta) {
  const double c = cosine(theta), s = sine(theta), ca = cosine(joint.alpha), sa = sine(joint.alpha);
  Pose pose;
  pose.rotation << c, -s * ca, s * sa,  //
      s, c * ca, -c * sa,               //
      0, sa, ca;
  pose.translation << joint.a * c, joint.a * s, joint.d;
  return pose;
}

}  // namespace

Chain::Chain(std::vector<Joint> joints, std::optional<std::size_t> driver)
    : joints_(std::move(joints)), driver_(driver) {
  const auto refuse = [](const Joint& joint, const char* why) {
    throw std::invalid_argument(fmt::format("joint {}: {}", joint.name, why));
  };
  for (const Joint& joint : joints_) {
    for (const double number : {joint.alpha, joint.a, joint.d, joint.zero, joint.lowest, joint.highest})
      if (!std::isfinite(number)) refuse(joint, "a number is not finite");
    if (joint.sense != 1 && joint.sense != -1) refuse(joint, "its sense is neither 1 nor -1");
    if (joint.lowest > joint.highest) refuse(joint, "its lowest angle is above its highest");
  }
  if (!driver_) return;
  if (*driver_ + 1 >= joints_.size()) throw std::invalid_argument("no joint comes after the driver");
  if (joints_[*driver_].alpha != 0) refuse(joints_[*driver_], "it drives, but the next joint is not parallel to it");
}

std::size_t Chain::find(const std::string& name) const {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (joints_[i].name == name) return i;
  throw std::invalid_argument(fmt::format("no joint is called {}", name));
}

void Chain::require_reachable(const Angles& angles) const {
  if (angles.size() != joints_.size())
    throw std::invalid_argument(fmt::format("{} angles for {} joints", angles.size(), joints_.size()));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (!(angles[i] >= joint.lowest && angles[i] <= joint.highest))
      throw std::out_of_range(fmt::format("joint {}: {} degrees are beyond its limits, {} to {}", joint.name, angles[i],
                                          joint.lowest, joint.highest));
  }
}

std::vector<Pose> Chain::frames(const Angles& angles) const {
  if (angles.size() != joints_.size())
    throw std::invalid_argument(fmt::format("{} angles for {} joints", angles.size(), joints_.size()));
  std::vector<Pose> frames{Pose{}};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    double turned = joints_[i].sense * angles[i];
    if (driver_ && i == *driver_ + 1) turned -= joints_[*driver_].sense * angles[*driver_];
    const Pose& last = frames.back();
    const Pose next = link(joints_[i], joints_[i].zero + turned);
    frames.push_back({last.rotation * next.rotation, last.rotation * next.translation + last.translation});
  }
  return frames;
}

Eigen::Vector3d Chain::place(const Angles& angles, const Eigen::Vector3d& point) const {
  const Pose flange = frames(angles).back();
  return flange.rotation * point + flange.translation;
}

Arc Chain::arc(const Angles& angles, std::size_t joint, double move, const Eigen::Vector3d& point) const {
  require_reachable(angles);
  Angles end = angles;
  end.at(joint) += move;
  require_reachable(end);
  const std::vector<Pose> all = frames(angles);
  Arc arc;
  arc.start = all.back().rotation * point + all.back().translation;
  arc.point = all[joint].translation;
  // Behind a driver and the joint that makes up for it, everything is shifted along with that joint's axis.
  if (joint == driver_) arc.point += arc.start - all[joint + 1].translation;
  arc.axis = (move < 0 ? -joints_[joint].sense : joints_[joint].sense) * all[joint].rotation.col(2);
  arc.degrees = std::abs(move);
  require_valid(arc);
  return arc;
}

}  // namespace touchstone::cell

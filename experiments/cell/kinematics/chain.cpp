// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/chain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/workloads/degrees.h"

namespace touchstone::kinematics {
namespace {

Pose after(const Pose& first, const Pose& then) {
  return {first.rotation * then.rotation, first.rotation * then.translation + first.translation};
}

/// Rodrigues' formula.
Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double degrees) {
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(),  //
      axis.z(), 0, -axis.x(),       //
      -axis.y(), axis.x(), 0;
  const double c = workloads::cosine(degrees), s = workloads::sine(degrees);
  return c * Eigen::Matrix3d::Identity() + s * cross + (1 - c) * (axis * axis.transpose());
}

}  // namespace

Pose link_of(const DenavitHartenberg& row) {
  const double c = workloads::cosine(row.theta), s = workloads::sine(row.theta), ca = workloads::cosine(row.alpha),
               sa = workloads::sine(row.alpha);
  Pose pose;
  pose.rotation << c, -s * ca, s * sa,  //
      s, c * ca, -c * sa,               //
      0, sa, ca;
  pose.translation << row.a * c, row.a * s, row.d;
  return pose;
}

Chain::Chain(std::vector<Joint> joints, Pose flange, std::optional<std::size_t> driver)
    : joints_(std::move(joints)), flange_(std::move(flange)), driver_(driver) {
  const auto require = [](bool holds, const Joint& joint, const char* otherwise) {
    if (!holds) throw std::invalid_argument(fmt::format("joint {}: {}", joint.name, otherwise));
  };
  for (const Joint& joint : joints_) {
    require(joint.origin.rotation.allFinite() && joint.origin.translation.allFinite() && joint.axis.allFinite() &&
                std::isfinite(joint.lowest) && std::isfinite(joint.highest),
            joint, "a number is not finite");
    require(std::abs(joint.axis.norm() - 1) < 1e-12, joint, "its axis is not of length 1");
    require(joint.lowest <= joint.highest, joint, "its lowest angle is above its highest");
  }
  if (!driver_) return;
  if (*driver_ >= joints_.size()) throw std::invalid_argument("the driver is not a joint");
  const Joint& first = joints_[*driver_];
  require(*driver_ + 1 < joints_.size(), first, "no joint comes behind it to make up for its turning");
  const Joint& next = joints_[*driver_ + 1];
  const Eigen::Vector3d axis = next.origin.rotation * next.axis;
  require(axis == first.axis || axis == -first.axis, next, "it is to make up for a joint that is not parallel to it");
  factor_ = axis == first.axis ? -1 : 1;
}

std::size_t Chain::find(const std::string& name) const {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (joints_[i].name == name) return i;
  throw std::invalid_argument(fmt::format("no joint is called {}", name));
}

Angles Chain::turns(const Angles& commanded) const {
  if (commanded.size() != joints_.size())
    throw std::invalid_argument(fmt::format("{} angles for {} joints", commanded.size(), joints_.size()));
  Angles turns = commanded;
  if (driver_) turns[*driver_ + 1] += factor_ * commanded[*driver_];
  return turns;
}

void Chain::require_reachable(const Angles& commanded) const {
  const Angles all = turns(commanded);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (!(all[i] >= joint.lowest && all[i] <= joint.highest))
      throw std::out_of_range(fmt::format("joint {}: {} degrees are beyond its limits, {} to {}", joint.name, all[i],
                                          joint.lowest, joint.highest));
  }
}

double Chain::room(const Angles& commanded, std::size_t joint, bool up) const {
  const Angles all = turns(commanded);
  const auto left = [&](std::size_t i, bool rises) {
    return rises ? joints_[i].highest - all[i] : all[i] - joints_[i].lowest;
  };
  const double own = left(joint, up);
  return joint == driver_ ? std::min(own, left(joint + 1, up == (factor_ > 0))) : own;
}

std::vector<Pose> Chain::frames(const Angles& commanded) const {
  const Angles all = turns(commanded);
  std::vector<Pose> frames;
  Pose last;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    last = after(last, joints_[i].origin);
    last.rotation = last.rotation * turn_about(joints_[i].axis, all[i]);
    frames.push_back(last);
  }
  frames.push_back(after(last, flange_));
  return frames;
}

Eigen::Vector3d Chain::place(const Angles& commanded, const Eigen::Vector3d& point) const {
  const Pose flange = frames(commanded).back();
  return flange.rotation * point + flange.translation;
}

Arc Chain::arc(const Angles& commanded, std::size_t joint, double move, const Eigen::Vector3d& point) const {
  require_reachable(commanded);
  Angles end = commanded;
  end.at(joint) += move;
  require_reachable(end);
  const std::vector<Pose> all = frames(commanded);
  Arc arc;
  arc.start = all.back().rotation * point + all.back().translation;
  arc.point = all[joint].translation;
  // What comes behind the joint that makes up for the driver is shifted along with that joint's origin.
  if (joint == driver_) arc.point += arc.start - all[joint + 1].translation;
  arc.axis = (move < 0 ? -1 : 1) * all[joint].rotation * joints_[joint].axis;
  arc.degrees = std::abs(move);
  require_valid(arc);
  return arc;
}

}  // namespace touchstone::kinematics

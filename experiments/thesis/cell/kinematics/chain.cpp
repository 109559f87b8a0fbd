// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/chain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/degrees.h"
#include "experiments/thesis/cell/model/poses.h"

namespace touchstone::kinematics {

Reach TwoLinks::reach(const LinkAngles& angles) const {
  return {first * workloads::sine(angles.lean) + second * workloads::cosine(angles.elevation),
          first * workloads::cosine(angles.lean) + second * workloads::sine(angles.elevation)};
}

std::vector<LinkAngles> TwoLinks::inverse(const Reach& point) const {
  const double distance = std::sqrt(point.out * point.out + point.up * point.up);
  if (distance == 0) return {};
  const double at_shoulder = (first * first + distance * distance - second * second) / (2 * first * distance);
  if (!(std::abs(at_shoulder) <= 1)) return {};
  const double to_point = workloads::arc_tangent(point.up, point.out), opened = workloads::arc_cosine(at_shoulder);
  std::vector<LinkAngles> solutions;
  for (const double side : {1.0, -1.0}) {
    const double up = to_point + side * opened;  // elevation of the first link
    const double elevation =
        workloads::arc_tangent(point.up - first * workloads::sine(up), point.out - first * workloads::cosine(up));
    const double lean = 90 - up;
    solutions.push_back({std::remainder(lean, 360), elevation});
    if (opened == 0 || opened == 180) break;
  }
  return solutions;
}

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

Chain::Chain(std::vector<Joint> joints, Pose flange, const std::vector<Compensation>& compensations, const Angles& rest)
    : joints_(std::move(joints)), flange_(std::move(flange)), by_driver_(joints_.size()) {
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
  if (compensations.empty()) return;
  const std::vector<Pose> at_rest = frames(rest.empty() ? Angles(joints_.size(), 0.0) : rest);
  for (const auto& [driver, by] : compensations) {
    if (driver >= joints_.size()) throw std::invalid_argument("the driver is not a joint");
    require(!by_driver_[driver].joint, joints_[driver], "two joints are to make up for its turning");
    require(by > driver && by < joints_.size(), joints_[driver], "no joint comes behind it to make up for its turning");
    const double along = (at_rest[driver].rotation * joints_[driver].axis).dot(at_rest[by].rotation * joints_[by].axis);
    require(std::abs(std::abs(along) - 1) < 1e-12, joints_[by],
            "it is to make up for a joint that is not parallel to it");
    by_driver_[driver] = {by, along > 0 ? -1.0 : 1.0};
  }
}

Angles Chain::turns(const Angles& commanded) const {
  if (commanded.size() != joints_.size())
    throw std::invalid_argument(fmt::format("{} angles for {} joints", commanded.size(), joints_.size()));
  Angles turns = commanded;
  for (std::size_t i = 0; i < by_driver_.size(); ++i)
    if (by_driver_[i].joint) turns[*by_driver_[i].joint] += by_driver_[i].factor * commanded[i];
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
  const auto& [by, factor] = by_driver_.at(joint);
  return by ? std::min(own, left(*by, up == (factor > 0))) : own;
}

std::vector<Pose> Chain::frames(const Angles& commanded) const {
  const Angles all = turns(commanded);
  std::vector<Pose> frames;
  Pose last;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    last = cell::within(last, joints_[i].origin);
    last.rotation = last.rotation * cell::rotation_about(joints_[i].axis, all[i]);
    frames.push_back(last);
  }
  frames.push_back(cell::within(last, flange_));
  return frames;
}

Eigen::Vector3d Chain::place(const Angles& commanded, const Eigen::Vector3d& point) const {
  const Pose flange = frames(commanded).back();
  return flange * point;
}

Arc Chain::arc(const Angles& commanded, std::size_t joint, double move, const Eigen::Vector3d& point) const {
  require_reachable(commanded);
  Angles end = commanded;
  end.at(joint) += move;
  require_reachable(end);
  const std::vector<Pose> all = frames(commanded);
  Arc arc;
  arc.start = all.back() * point;
  arc.point = all[joint].translation;
  // What comes behind the joint that makes up for the driver is shifted along with that joint's origin.
  if (const auto by = compensating(joint)) arc.point += arc.start - all[*by].translation;
  arc.axis = (move < 0 ? -1 : 1) * all[joint].rotation * joints_[joint].axis;
  arc.degrees = std::abs(move);
  require_valid(arc);
  return arc;
}

}  // namespace touchstone::kinematics

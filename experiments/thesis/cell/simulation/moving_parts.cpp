// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/simulation/moving_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace touchstone::cell {

JointTurn::JointTurn(const Arm& arm, const kinematics::Angles& from, std::optional<Moved> joint)
    : arm_(&arm), joint_(joint) {
  if (!joint) return;
  const std::vector<Pose> frames = arm.chain.frames(from);
  on_axis_ = frames[*joint].translation;
  axis_ = frames[*joint].rotation * arm.chain.joints()[*joint].axis;
  if (const auto by = arm.chain.compensating(*joint)) {
    shifted_from_ = *by;
    pivot_ = frames[*by].translation;
    shift_ = from_axis(*pivot_) * kGenerous;
  }
}

JointTurn::Motion JointTurn::motion(std::size_t link) const {
  const auto frame = arm_->links[link].frame;
  if (!joint_ || !frame || *frame < *joint_) return Motion::None;
  return shifted_from_ && *frame >= *shifted_from_ ? Motion::Shifted : Motion::Turned;
}

double JointTurn::moved(Motion motion, const Eigen::Vector3d& center, double radius, double degrees) const {
  if (motion == Motion::None) return 0;
  const double lever = motion == Motion::Shifted ? shift_ : from_axis(center) + radius;
  return lever * degrees * (std::numbers::pi / 180) * kGenerous;
}

std::string_view to_string(Mover mover) {
  constexpr std::array<std::string_view, kMovers.size()> words{"arm", "held material", "sphere"};
  return words[static_cast<std::size_t>(mover)];
}

Pose MovingPart::pose(const std::vector<Pose>& links, const MaterialTransfer& state) const {
  if (mover == Mover::Held) return within(links[link], *state.in_flange);
  Pose pose = links[link];
  if (finger && state.grip) pose.translation += pose.rotation * (state.grip->fingers[*finger].way * closes);
  return pose;
}

Ball MovingPart::around(const Pose& pose) const {
  const touchstone::Box box = triangles.whole();
  const Eigen::Vector3d center = (box.low + box.high) / 2;
  const double reach = (box.high - center).norm() * JointTurn::kGenerous;
  // Products of rotations of an arm are off by some 1e-15 an element, so is each of nine products and sums.
  const double error = 1e-13 * (center.cwiseAbs().sum() + reach + pose.translation.cwiseAbs().sum());
  return {pose * center, reach + error};
}

DistanceBounds MovingPart::distance_from(const TriangleTree& still, const Pose& pose, double cutoff) const {
  DistanceBounds bounds = distance(triangles, pose, still, cutoff + radius);
  bounds.lower = std::max(0.0, bounds.lower - radius * JointTurn::kGenerous);
  bounds.upper = std::max(0.0, bounds.upper - radius);
  return bounds;
}

std::vector<std::vector<NamedTriangle>> by_owner(const std::vector<NamedTriangle>& triangles) {
  std::map<std::uint32_t, std::vector<NamedTriangle>> owners;
  for (const NamedTriangle& triangle : triangles) owners[triangle.owner].push_back(triangle);
  std::vector<std::vector<NamedTriangle>> parts;
  for (auto& [owner, its] : owners) parts.push_back(std::move(its));
  return parts;
}

std::vector<MovingPart> moving_parts(const Workcell& workcell, bool foot) {
  const Arm& arm = workcell.arm();
  std::vector<MovingPart> parts;
  for (const Covered& part : workcell.covered())
    if (part.carrier == Carrier::Link && (foot || arm.links[part.link].frame))
      parts.push_back({Mover::Arm, part.name, part.link, TriangleTree(part.triangles), 0});
  const std::size_t flange = arm.links.size() - 1;
  const auto add = [&](Mover mover, const std::vector<NamedTriangle>& triangles) {
    for (auto& its : by_owner(triangles)) {
      const std::string& name = workcell.names()[its.front().owner];
      parts.push_back({mover, name, flange, TriangleTree(std::move(its)), 0});
    }
  };
  add(Mover::Arm, workcell.gripper());
  for (std::size_t i = 0; i < workcell.fingers().size(); ++i) {
    add(Mover::Arm, workcell.fingers()[i]);
    parts.back().finger = i;
    parts.back().closes = workcell.cell().gripper.fingers->shift(i, 1);
  }
  add(Mover::Held, workcell.material());
  const Ball& sphere = arm.sphere;
  parts.push_back({Mover::Sphere, "sphere", flange, TriangleTree({{{sphere.center, sphere.center, sphere.center}, 0}}),
                   sphere.radius});
  return parts;
}

std::vector<Stretch> stretches_of(const Process& process) {
  std::vector<Stretch> stretches;
  const auto& transfers = process.transfers;
  for (std::size_t i = 0; i < transfers.size() && !process.stops.empty(); ++i)
    stretches.push_back({transfers[i].stop, i + 1 < transfers.size() ? transfers[i + 1].stop : process.stops.size() - 1,
                         &transfers[i]});
  return stretches;
}

double moved(const Arm& arm, const kinematics::Angles& from, const Step& step, std::size_t link, const Ball& around) {
  double sum = 0;
  for (const Moved joint : {kElbow, kShoulder, kBase}) {
    if (step.by[joint] == 0) continue;
    const JointTurn turn(arm, from, joint);
    sum += turn.moved(turn.motion(link), around.center, around.radius + sum, std::abs(step.by[joint]));
  }
  return sum;
}

WayBetween way_between(const Arm& arm, const std::vector<MovingPart>& parts, const Stop& from, const Stop& to,
                       const std::vector<Pose>& links, const MaterialTransfer& state) {
  WayBetween way{step_between(from, to), {}};
  for (const MovingPart& part : parts) {
    if (!part.is_there(state)) {
      way.moved.push_back(0);
      continue;
    }
    way.moved.push_back(moved(arm, from.commanded, way.step, part.link, part.around(part.pose(links, state))));
  }
  return way;
}

}  // namespace touchstone::cell

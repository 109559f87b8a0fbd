// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/layout.h"

#include <cmath>

#include "experiments/cases/workloads/degrees.h"

namespace touchstone::kinematics {
namespace {

/// From the elbow at home: along the forearm; if the wrist is locked, then straight down to the sphere's centre.
Reach second_link(const Layout& layout) {
  const double down = layout.hand == Hand::Locked ? kHand + layout.sphere_distance : 0;
  return {kForearm * workloads::cosine(layout.home.elevation),
          kForearm * workloads::sine(layout.home.elevation) - down};
}

double length(const Reach& reach) { return std::sqrt(reach.out * reach.out + reach.up * reach.up); }

}  // namespace

Station Layout::storage(std::size_t place, double angle) const {
  return {kStorageHome + angle, storage_radius.at(place), storage_height.at(place)};
}

Station Layout::machine() const { return {kMachineAzimuth, machine_radius, machine_height}; }

SphereArm::SphereArm(const Layout& layout)
    : coupling_(layout.coupling), below_(layout.hand == Hand::Level ? kHand + layout.sphere_distance : 0) {
  const Reach second = second_link(layout);
  home_ = {layout.home.lean, workloads::arc_tangent(second.up, second.out)};
  links_ = {kUpperArm, length(second)};
}

Reach SphereArm::reach(const Commands& commands) const {
  const double carried = coupling_ == Coupling::Serial ? commands.shoulder : 0;
  const Reach reach = links_.reach({home_.lean + commands.shoulder, home_.elevation + commands.elbow - carried});
  return {reach.out, reach.up + kShoulderHeight - below_};
}

std::optional<SphereArm::Commands> SphereArm::inverse(const Reach& center) const {
  std::optional<Commands> nearest;
  const auto away = [](const Commands& c) { return std::abs(c.shoulder) + std::abs(c.elbow); };
  for (const LinkAngles& angles : links_.inverse({center.out, center.up - kShoulderHeight + below_})) {
    Commands commands{std::remainder(angles.lean - home_.lean, 360), 0};
    const double carried = coupling_ == Coupling::Serial ? commands.shoulder : 0;
    commands.elbow = std::remainder(angles.elevation - home_.elevation + carried, 360);
    if (!nearest || away(commands) < away(*nearest)) nearest = commands;
  }
  return nearest;
}

Angles home_pose(const Layout& layout) {
  return aristo_pose(layout.coupling, 0, layout.home, layout.hand == Hand::Level ? 0 : -layout.home.elevation);
}

Eigen::Vector3d sphere_center(const Layout& layout) { return {0, 0, layout.sphere_distance}; }

}  // namespace touchstone::kinematics

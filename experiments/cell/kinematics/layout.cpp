// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/layout.h"

#include <cmath>

#include "experiments/workloads/degrees.h"

namespace touchstone::kinematics {
namespace {

/// From the elbow to the sphere's centre at home: along the forearm, then straight down.
Reach second_link(const Layout& layout) {
  return {kForearm * workloads::cosine(layout.home.elevation),
          kForearm * workloads::sine(layout.home.elevation) - kHand - layout.sphere_distance};
}

double length(const Reach& reach) { return std::sqrt(reach.out * reach.out + reach.up * reach.up); }

/// A cube in a station's frame, its corners at x0, y0, 0.
std::vector<Polygon> cube(const Station& station, double x0, double y0, double side) {
  const double c = workloads::cosine(station.azimuth), s = workloads::sine(station.azimuth);
  const auto corner = [&](int x, int y, int z) -> Eigen::Vector3d {
    const double along = station.radius + x0 + x * side, across = y0 + y * side;
    return {c * along - s * across, s * along + c * across, station.height + z * side};
  };
  const auto face = [&](std::array<int, 3> a, std::array<int, 3> b, std::array<int, 3> d, std::array<int, 3> e) {
    Loop loop;
    for (const auto& [x, y, z] : {a, b, d, e}) loop.push_back(corner(x, y, z));
    return Polygon(loop);
  };
  return {face({0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}), face({0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}),
          face({0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}), face({1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}),
          face({0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}), face({0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0})};
}

}  // namespace

Station Layout::storage(std::size_t place, double angle) const {
  return {kStorageHome + angle, storage_radius.at(place), storage_height.at(place)};
}

Station Layout::machine() const { return {kMachineAzimuth, machine_radius, machine_height}; }

SphereArm::SphereArm(const Layout& layout) : coupling_(layout.coupling) {
  const Reach second = second_link(layout);
  home_ = {layout.home.lean, workloads::arc_tangent(second.up, second.out)};
  links_ = {kUpperArm, length(second)};
}

Reach SphereArm::reach(const Commands& commands) const {
  const double carried = coupling_ == Coupling::Serial ? commands.shoulder : 0;
  const Reach reach = links_.reach({home_.lean + commands.shoulder, home_.elevation + commands.elbow - carried});
  return {reach.out, reach.up + kShoulderHeight};
}

std::optional<SphereArm::Commands> SphereArm::inverse(const Reach& center) const {
  std::optional<Commands> nearest;
  const auto away = [](const Commands& c) { return std::abs(c.shoulder) + std::abs(c.elbow); };
  for (const LinkAngles& angles : links_.inverse({center.out, center.up - kShoulderHeight})) {
    Commands commands{std::remainder(angles.lean - home_.lean, 360), 0};
    const double carried = coupling_ == Coupling::Serial ? commands.shoulder : 0;
    commands.elbow = std::remainder(angles.elevation - home_.elevation + carried, 360);
    if (!nearest || away(commands) < away(*nearest)) nearest = commands;
  }
  return nearest;
}

Angles home_pose(const Layout& layout) { return aristo_pose(layout.coupling, 0, layout.home, -layout.home.elevation); }

Eigen::Vector3d sphere_center(const Layout& layout) { return {0, 0, layout.sphere_distance}; }

std::vector<Polygon> material_in_storage(const Layout& layout, const Station& storage) {
  return cube(storage, -layout.side / 2, -layout.gap - layout.side, layout.side);
}

std::vector<Polygon> material_at_machine(const Layout& layout) {
  return cube(layout.machine(), -layout.side / 2, -layout.side / 2, layout.side);
}

}  // namespace touchstone::kinematics

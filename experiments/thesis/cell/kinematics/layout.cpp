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

Angles home_pose(const Layout& layout) {
  return aristo_pose(layout.coupling, 0, layout.home, layout.hand == Hand::Level ? 0 : -layout.home.elevation);
}

Eigen::Vector3d sphere_center(const Layout& layout) { return {0, 0, layout.sphere_distance}; }

namespace {

constexpr double kHalf = 0.5;  // degrees before a stop: as far from the stop before it
constexpr double kSteepest = 60;

double height_difference(const Layout& layout) { return layout.storage_height[1] - layout.storage_height[0]; }

double to_a_tenth(double x) { return std::round(x * 10) / 10; }

}  // namespace

// Case 1: half a degree before the base faces the storage, the centre is `radius` beside the material's side, which is
// `gap` beside the station's x axis, a little below its upper face. Case 2 and machine: half a degree before the
// shoulder is down, the centre is over the edge between that side and the upper face.
std::optional<Layout> solve_layout(const Linkage& linkage, const LinkAngles& home, const Assumptions& assumptions) {
  const auto& [distance, radius, side, drop] = assumptions;
  const auto& [first, second] = kCases;
  Layout layout{linkage.coupling, linkage.hand, home, distance, radius, side, 0, drop, {}, {}, 0, 0, 0};
  const SphereArm arm(layout);

  const Reach beside = arm.reach({0.0 + first.shoulder, 0.0 + first.elbow});
  const Reach above = arm.reach({second.shoulder - kHalf, 0.0 + second.elbow});
  const Reach at_machine =
      arm.reach({first.shoulder + first.shoulder_to_machine - kHalf, 0.0 + first.elbow + first.elbow_to_machine});
  layout.gap = radius - beside.out * workloads::sine(kHalf);
  if (beside.out <= 0 || above.out <= 0 || at_machine.out <= 0 || layout.gap <= -radius) return std::nullopt;
  const double over_edge = layout.gap > 0 ? std::sqrt(radius * radius - layout.gap * layout.gap) : radius;
  layout.storage_radius = {beside.out * workloads::cosine(kHalf), above.out};
  layout.storage_height = {beside.up + below_upper_face(radius) - side, above.up - side - over_edge};
  layout.machine_radius = at_machine.out;
  layout.machine_height = at_machine.up - side - over_edge - drop;
  const Reach gripped = arm.reach({0.0 + second.shoulder, 0.0 + second.elbow});
  const Reach lifted = arm.reach({second.shoulder + second.lift + kHalf, 0.0 + second.elbow});
  layout.clearance = lifted.up - gripped.up;
  if (layout.clearance <= 0) return std::nullopt;
  return layout;
}

std::vector<double> leans_of_one_height(const Linkage& linkage, double elevation, const Assumptions& assumptions) {
  std::vector<double> leans;
  const auto difference = [&](double lean) -> std::optional<double> {
    const auto layout = solve_layout(linkage, {lean, elevation}, assumptions);
    if (!layout) return std::nullopt;
    return height_difference(*layout);
  };
  for (double begin = -kSteepest; begin < kSteepest; ++begin) {
    double low = begin, high = begin + 1;
    const auto at_low = difference(low), at_high = difference(high);
    if (!at_low || !at_high || (*at_low > 0) == (*at_high > 0)) continue;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      const auto here = difference(middle);
      if (!here) break;
      ((*here > 0) == (*at_low > 0) ? low : high) = middle;
    }
    leans.push_back(low);
  }
  return leans;
}

Layout chosen_layout() {
  const Linkage linkage{Coupling::KeepsElevation, Hand::Level};
  const double lean = to_a_tenth(leans_of_one_height(linkage, kChosenElevation).front());
  Layout layout = solve_layout(linkage, {lean, kChosenElevation}).value();
  const double height = to_a_tenth((layout.storage_height[0] + layout.storage_height[1]) / 2);
  layout.storage_height = {height, height};
  for (double* length : {&layout.gap, &layout.storage_radius[0], &layout.storage_radius[1], &layout.machine_radius,
                         &layout.machine_height, &layout.clearance})
    *length = to_a_tenth(*length);
  return layout;
}

}  // namespace touchstone::kinematics

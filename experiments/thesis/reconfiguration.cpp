// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/reconfiguration.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/workloads/degrees.h"

namespace touchstone::thesis_figures {
namespace {

using namespace kinematics;

/// By the moves, or by why the last approach failed.
Outcome outcome_of(const SimulatedPath& path) {
  if (path.complete()) {
    const auto contact = std::ranges::find(path.moves, Until::Contact, &Move::until);
    return contact->joint == kBase ? Outcome::FromSide : Outcome::FromAbove;
  }
  switch (*path.cause) {
    case FailureCause::OutOfReach: return Outcome::OutOfReach;
    case FailureCause::JointLimit: return Outcome::JointLimit;
    case FailureCause::InTheWay: return Outcome::InTheWay;
    case FailureCause::NoContact: break;
  }
  return Outcome::Nothing;
}

using Corners = std::array<Eigen::Vector2d, 4>;

/// Returns the corners, in the cell, of a box in the frame of a station.
Corners corners_of(const Eigen::AlignedBox2d& box, double azimuth, double radius) {
  const double c = workloads::cosine(azimuth), s = workloads::sine(azimuth);
  const auto at = [&](double x, double y) -> Eigen::Vector2d {
    x += radius;
    return {c * x - s * y, s * x + c * y};
  };
  return {at(box.min().x(), box.min().y()), at(box.max().x(), box.min().y()), at(box.max().x(), box.max().y()),
          at(box.min().x(), box.max().y())};
}

/// Two rectangles overlap unless a side of one separates them.
bool overlap(const Corners& a, const Corners& b) {
  for (const Corners* box : {&a, &b})
    for (std::size_t side = 0; side < 2; ++side) {
      const Eigen::Vector2d axis = (*box)[side + 1] - (*box)[side];
      const auto range = [&](const Corners& corners) {
        const auto along = [&](const Eigen::Vector2d& corner) { return axis.dot(corner); };
        const auto [low, high] = std::ranges::minmax(corners, {}, along);
        return std::pair(along(low), along(high));
      };
      const auto [a_low, a_high] = range(a);
      const auto [b_low, b_high] = range(b);
      if (a_high <= b_low || b_high <= a_low) return false;
    }
  return true;
}

}  // namespace

std::string_view to_string(Outcome outcome) {
  constexpr std::array<std::string_view, 8> words{"from the side", "from above",  "on the robot", "on the machine",
                                                  "out of reach",  "joint limit", "in the way",   "no contact"};
  return words[static_cast<std::size_t>(outcome)];
}

FloorPlan floor_plan(const std::vector<cell::ModelPart>& parts) {
  FloorPlan plan{0, {}, {}};
  for (const cell::ModelPart& part : parts)
    for (const cell::Face& face : part.faces.faces)
      for (std::size_t i = 0; i < face.polygon.vertex_count(); ++i) {
        const Eigen::Vector2d at = face.polygon.vertex(i).head<2>();
        if (part.carrier == cell::Carrier::Storage) plan.storage.extend(at);
        if (part.carrier == cell::Carrier::Machine) plan.machine.extend(at);
        if (part.carrier == cell::Carrier::Link && part.link <= 1) plan.body = std::max(plan.body, at.norm());
      }
  return plan;
}

StoragePosition try_position(const Layout& layout, const FloorPlan& plan, double angle, double radius, double height) {
  const Station storage{kStorageHome + angle, radius, height};
  const double nearest = radius + plan.storage.min().x();
  if (nearest < plan.body)
    return {angle, radius, height, Outcome::OnRobot,
            fmt::format("the storage begins {:.1f} mm from the base's axis, the robot's body needs {:.1f}; a radius of "
                        "{:.1f} would fit",
                        nearest, plan.body, plan.least_radius())};
  const Station machine = layout.machine();
  if (overlap(corners_of(plan.storage, storage.azimuth, radius),
              corners_of(plan.machine, machine.azimuth, machine.radius)))
    return {angle, radius, height, Outcome::OnMachine, "seen from above, the storage would stand in the machine"};
  const SimulatedPath path = simulate(layout, storage);
  return {angle, radius, height, outcome_of(path), path.failure};
}

Stretch longest_stretch(const std::vector<StoragePosition>& places) {
  Stretch best{1, 0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::size_t end = i;
    while (end < places.size() && completes(places[end].outcome)) ++end;
    if (end > i && (best.empty() || end - i > best.last - best.first + 1)) best = {i, end - 1};
    i = end;
  }
  return best;
}

}  // namespace touchstone::thesis_figures

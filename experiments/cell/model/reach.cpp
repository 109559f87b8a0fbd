// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/model/reach.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/cell/model/bounds.h"
#include "experiments/cell/model/cell_entry.h"

namespace touchstone::cell {
namespace {

/// Which radii would do at this height, for material whose middle is there in the station's frame.
std::string fitting(const Reach& reach, double around, const Eigen::Vector3d& middle, double height) {
  const double up = height + middle.z() - reach.height, outer = reach.outer + around, inner = reach.inner - around;
  if (std::abs(up) > outer)
    return fmt::format("no radius would fit at this height, heights from {:.6g} to {:.6g} might",
                       std::max(0.0, height - up - outer), height - up + outer);
  // From the circle on which the second joint lies, in the plan; then along the station's x axis.
  const auto radius = [&](double distance) {
    const double out = reach.radius + std::sqrt(std::max(0.0, distance * distance - up * up));
    return std::max(0.0, std::sqrt(std::max(0.0, out * out - middle.y() * middle.y())) - middle.x());
  };
  const double least = inner > std::abs(up) ? radius(inner) : 0;
  return fmt::format("a radius from {:.6g} to {:.6g} would fit at this height", least, radius(outer));
}

void check(const Cell& cell, const Station& station, const char* key, const Reach& reach) {
  const Eigen::AlignedBox3d material = bounds_of(cell.material.solid);
  const double around = cell.gripper.sphere.radius + material.diagonal().norm() / 2;
  const double azimuth = station.azimuth() * std::numbers::pi / 180;
  for (const Slot& slot : station.slots) {
    const Eigen::Vector3d middle = slot.place + material.center();
    const double x = station.radius + middle.x(), y = middle.y();
    const double distance =
        reach.distance({x * std::cos(azimuth) - y * std::sin(azimuth), x * std::sin(azimuth) + y * std::cos(azimuth),
                        station.height + middle.z()});
    if (distance > reach.outer + around || distance < reach.inner - around)
      throw BadCell(
          fmt::format("{}: {}.radius: {}: material in slot \"{}\" is {:.6g} from the second joint, where the arm holds "
                      "its sphere {:.6g} to {:.6g} away; {}",
                      cell.file.string(), key, distance < reach.inner ? "too near" : "too far", slot.name, distance,
                      reach.inner, reach.outer, fitting(reach, around, middle, station.height)));
  }
}

}  // namespace

double Reach::distance(const Eigen::Vector3d& point) const {
  return std::hypot(std::hypot(point.x(), point.y()) - radius, point.z() - height);
}

Reach reach_of(const Cell& cell) {
  const Robot& robot = cell.robot;
  const Eigen::Vector3d first = robot.base.translation + robot.base.rotation * robot.joints[0].origin.translation;
  // The second joint's origin in the frame of the first, whose axis is the cell's.
  Eigen::Vector3d second = Eigen::Vector3d::Zero();
  double sum = cell.gripper.sphere.center.norm(), longest = sum;
  for (std::size_t i = 1; i < robot.joints.size(); ++i) {
    const Eigen::Vector3d& step = robot.joints[i].origin.translation;
    if (i == 1) {
      second = robot.base.rotation * robot.joints[0].origin.rotation * step;
      continue;
    }
    sum += step.norm();
    longest = std::max(longest, step.norm());
  }
  return {std::hypot(second.x(), second.y()), first.z() + second.z(), std::max(0.0, 2 * longest - sum), sum};
}

void check_reach(const Cell& cell) {
  const Reach reach = reach_of(cell);
  check(cell, cell.storage, "storage", reach);
  check(cell, cell.machine, "machine", reach);
}

}  // namespace touchstone::cell

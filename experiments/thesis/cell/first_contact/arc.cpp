// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/arc.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "experiments/cases/workloads/degrees.h"

namespace touchstone::kinematics {

void require_valid(const Arc& arc) {
  if (!arc.start.allFinite() || !arc.point.allFinite() || !arc.axis.allFinite())
    throw std::invalid_argument("the arc has a coordinate that is not finite");
  if (arc.axis.isZero(0)) throw std::invalid_argument("the axis of the arc has length 0");
  if (!(arc.degrees >= 0 && arc.degrees <= 360))
    throw std::invalid_argument(fmt::format("the arc turns by {} degrees, not by 0 to 360", arc.degrees));
}

// What underflows is far below the last place of the largest coordinate, which is from 1 to 2.
Eigen::Vector3d direction_of(const Eigen::Vector3d& v) {
  const int exponent = std::ilogb(v.cwiseAbs().maxCoeff());
  return v.unaryExpr([&](double x) { return std::scalbn(x, -exponent); }).stableNormalized();
}

Eigen::Vector3d point_at(const Arc& arc, double degrees) {
  const Eigen::Vector3d unit = direction_of(arc.axis), v = arc.start - arc.point;
  const Eigen::Vector3d along = v.dot(unit) * unit;
  if (degrees == 0) return arc.start;
  return arc.point + along + workloads::cosine(degrees) * (v - along) + workloads::sine(degrees) * unit.cross(v);
}

}  // namespace touchstone::kinematics

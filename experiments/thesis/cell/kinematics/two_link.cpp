// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/two_link.h"

#include <cmath>

#include "experiments/cases/workloads/degrees.h"

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

}  // namespace touchstone::kinematics

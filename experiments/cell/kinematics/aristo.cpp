// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cell/kinematics/aristo.h"

#include <cmath>

#include "experiments/cell/kinematics/degrees.h"
#include "experiments/cell/kinematics/two_link.h"

namespace touchstone::cell {
namespace {

double elbow_command(Coupling coupling, const LinkAngles& angles) {
  return coupling == Coupling::KeepsElevation ? angles.elevation : angles.elevation + angles.lean;
}

/// More than -180 to 180.
double within_half_turn(double degrees) {
  const double rest = std::remainder(degrees, 360);
  return rest == -180 ? 180 : rest;
}

}  // namespace

std::string_view word(Coupling coupling) { return coupling == Coupling::KeepsElevation ? "keeps-elevation" : "serial"; }

Chain aristo(Coupling coupling) {
  std::vector<Joint> joints{
      {"base", 90, 0, kShoulderHeight, 0, 1, -220, 60},
      {"shoulder", 0, kUpperArm, 0, 90, -1, -60, 100},
      {"elbow", 90, 0, 0, 180, 1, -90, 120},
      {"wrist roll", 90, 0, -kForearm, 0, 1, -180, 180},
      {"wrist pitch", 90, 0, 0, 90, 1, -120, 120},
      {"hand roll", 0, 0, kHand, 0, 1, -360, 360},
  };
  if (coupling == Coupling::Serial) return Chain(std::move(joints));
  return Chain(std::move(joints), kShoulder);
}

Angles aristo_pose(Coupling coupling, double base, double lean, double elevation) {
  return {base, lean, elbow_command(coupling, {lean, elevation}), 0, elevation, 0};
}

std::vector<ArmAngles> inverse(Coupling coupling, const Eigen::Vector3d& wrist) {
  const TwoLinks arm{kUpperArm, kForearm};
  const double out = std::sqrt(wrist.x() * wrist.x() + wrist.y() * wrist.y());
  const double base = arc_tangent(wrist.y(), wrist.x());
  std::vector<ArmAngles> solutions;
  for (const LinkAngles& angles : arm.inverse({out, wrist.z() - kShoulderHeight}))
    solutions.push_back({base, within_half_turn(angles.lean), within_half_turn(elbow_command(coupling, angles))});
  return solutions;
}

}  // namespace touchstone::cell

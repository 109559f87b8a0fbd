// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/kinematics/aristo.h"

namespace touchstone::kinematics {

std::string_view to_string(Coupling coupling) {
  return coupling == Coupling::KeepsElevation ? "keeps-elevation" : "serial";
}

std::string_view to_string(Hand hand) { return hand == Hand::Level ? "level" : "locked"; }

Chain aristo(Coupling coupling, Hand hand) {
  struct Row {
    const char* name;
    DenavitHartenberg link;
    int sense;  ///< of the table's z
    double lowest, highest;
  };
  const Row rows[] = {
      {"base", {90, 0, kShoulderHeight, 0}, 1, -270, 90}, {"shoulder", {0, kUpperArm, 0, 90}, -1, -90, 90},
      {"elbow", {90, 0, 0, 180}, 1, -120, 120},           {"wrist roll", {90, 0, -kForearm, 0}, 1, -180, 180},
      {"wrist pitch", {90, 0, 0, 90}, -1, -120, 120},     {"hand roll", {0, 0, kHand, 0}, 1, -180, 180},
  };
  // The table's joint turns before its link: a joint's frame is that of the link before it.
  std::vector<Joint> joints;
  Pose last;
  for (const Row& row : rows) {
    joints.push_back({row.name, last, {0, 0, static_cast<double>(row.sense)}, row.lowest, row.highest});
    last = link_of(row.link);
  }
  std::vector<Compensation> compensations;
  if (coupling == Coupling::KeepsElevation) compensations.push_back({kShoulder, kElbow});
  if (hand == Hand::Level) {
    if (coupling == Coupling::Serial) compensations.push_back({kShoulder, kWristPitch});
    compensations.push_back({kElbow, kWristPitch});
  }
  return {std::move(joints), last, compensations};
}

Angles aristo_pose(Coupling coupling, double base, const LinkAngles& arm, double hand) {
  const double elbow = coupling == Coupling::KeepsElevation ? arm.elevation : arm.elevation + arm.lean;
  return {base, arm.lean, elbow, 0, hand, 0};
}

Eigen::Vector3d wrist(const Chain& aristo, const Angles& commanded) {
  return aristo.frames(commanded)[kWristPitch].translation;
}

}  // namespace touchstone::kinematics

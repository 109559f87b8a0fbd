// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/chain.h"

/// The MTAB Aristo. Lengths and the zero of all commands (upper arm vertical, forearm horizontal, hand straight down)
/// are those of a public Denavit-Hartenberg table [ghaayathri]; senses, joint limits and couplings are chosen: no
/// public source gives them.
namespace touchstone::cell {

/// What the forearm does while the shoulder turns. Chosen: no public source tells.
enum class Coupling {
  KeepsElevation,  ///< it keeps its elevation, as with parallel bars
  Serial,          ///< it turns with the upper arm
};
[[nodiscard]] std::string_view word(Coupling coupling);

/// The joints, in order. Commands that are positive turn the base counter-clockwise (seen from above), the shoulder
/// down (it leans forward), the elbow up.
enum AristoJoint : std::size_t { kBase, kShoulder, kElbow, kWristRoll, kWristPitch, kHandRoll };

[[nodiscard]] Chain aristo(Coupling coupling);

inline constexpr double kShoulderHeight = 0.322, kUpperArm = 0.300, kForearm = 0.375, kHand = 0.063;  // metres

/// The hand straight down while the forearm is `elevation` degrees above the horizontal.
[[nodiscard]] Angles aristo_pose(Coupling coupling, double base, double lean, double elevation);

/// Commands of base, shoulder and elbow.
struct ArmAngles {
  double base, shoulder, elbow;
};

/// The commands that bring the wrist point there, base facing it: none, one or two (the elbow above the line from
/// shoulder to wrist, then below it). In doubles; joint limits are not looked at. On the axis of the base, where any
/// base angle will do, it is 0.
[[nodiscard]] std::vector<ArmAngles> inverse(Coupling coupling, const Eigen::Vector3d& wrist);

}  // namespace touchstone::cell

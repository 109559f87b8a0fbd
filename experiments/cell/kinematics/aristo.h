// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/kinematics/two_link.h"

/// The MTAB Aristo, in millimetres and degrees; z up, the origin on the axis of the base.
///
/// Where all commands are 0 the upper arm is upright, the forearm along x and the hand straight down. That and the
/// lengths are those of a public Denavit-Hartenberg table [ghaayathri]. Joint limits and the coupling are chosen: no
/// public source gives them.
namespace touchstone::kinematics {

/// What the forearm does while the shoulder turns.
enum class Coupling {
  KeepsElevation,  ///< it is shifted, as by parallel bars
  Serial,          ///< it turns with the upper arm
};
inline constexpr std::array kCouplings{Coupling::KeepsElevation, Coupling::Serial};
/// `keeps-elevation`, `serial`.
[[nodiscard]] std::string_view word(Coupling coupling);

/// The joints, in order. Positive commands turn the base counter-clockwise as seen from above, lean the upper arm
/// forward and down, raise the forearm, and raise the hand.
enum AristoJoint : std::size_t { kBase, kShoulder, kElbow, kWristRoll, kWristPitch, kHandRoll };

inline constexpr double kShoulderHeight = 322, kUpperArm = 300, kForearm = 375, kHand = 63;

[[nodiscard]] Chain aristo(Coupling coupling);

/// The commands for an upper arm and a forearm that point so, the hand raised from straight down by `hand` degrees
/// where the forearm is horizontal, and turned along with it.
[[nodiscard]] Angles aristo_pose(Coupling coupling, double base, const LinkAngles& arm, double hand = 0);

/// The wrist point, where the axes of the last three joints meet.
[[nodiscard]] Eigen::Vector3d wrist(const Chain& aristo, const Angles& commanded);

/// The commands that bring the wrist point there with the base facing it, hand as above with 0: none where it is out of
/// reach, else the one with the elbow above the line from shoulder to wrist, then the one with it below; one where the
/// arm is straight. In doubles. Joint limits are not looked at. On the axis of the base, where any base angle would
/// do, that is 0.
[[nodiscard]] std::vector<Angles> inverse(Coupling coupling, const Eigen::Vector3d& wrist);

}  // namespace touchstone::kinematics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>

#include "experiments/thesis/cell/kinematics/chain.h"

/// The MTAB Aristo, in millimetres and degrees; z up, the origin on the axis of the base.
///
/// If all commands are 0, the upper arm is upright, the forearm points along x and the hand straight down. This pose
/// and the lengths are those of a public Denavit-Hartenberg table [ghaayathri]. Joint limits and the coupling are
/// chosen, because no public source gives them.
namespace touchstone::kinematics {

/// The motion of the forearm while the shoulder turns.
enum class Coupling {
  KeepsElevation,  ///< it is shifted, as by parallel bars
  Serial,          ///< it turns with the upper arm
};
inline constexpr std::array kCouplings{Coupling::KeepsElevation, Coupling::Serial};
/// `keeps-elevation`, `serial`.
[[nodiscard]] std::string_view to_string(Coupling coupling);

/// The motion of the hand while shoulder and elbow turn.
enum class Hand {
  Level,   ///< the wrist's pitch undoes what would turn it: the hand stays upright
  Locked,  ///< it turns with the forearm
};
inline constexpr std::array kHands{Hand::Level, Hand::Locked};
/// `level`, `locked`.
[[nodiscard]] std::string_view to_string(Hand hand);

/// The joints, in order. Positive commands turn the base counter-clockwise as seen from above, lean the upper arm
/// forward and down, raise the forearm, and raise the hand.
enum AristoJoint : std::size_t { kBase, kShoulder, kElbow, kWristRoll, kWristPitch, kHandRoll };

inline constexpr double kShoulderHeight = 322, kUpperArm = 300, kForearm = 375, kHand = 63;

[[nodiscard]] Chain aristo(Coupling coupling, Hand hand = Hand::Locked);

/// Returns the commands for the given directions of upper arm and forearm. The hand is raised from straight down by
/// `hand` degrees if the forearm is horizontal or the hand is level.
[[nodiscard]] Angles aristo_pose(Coupling coupling, double base, const LinkAngles& arm, double hand = 0);

/// Returns the wrist point, where the axes of the last three joints meet.
[[nodiscard]] Eigen::Vector3d wrist(const Chain& aristo, const Angles& commanded);

}  // namespace touchstone::kinematics

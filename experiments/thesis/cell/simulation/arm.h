// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/thesis/cell/kinematics/chain.h"
#include "experiments/thesis/cell/model/cell.h"
#include "experiments/thesis/cell/model/poses.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// The joints that the process moves: the first three that turn. The others keep their angles at home.
enum Moved : std::size_t { kBase, kShoulder, kElbow };

/// A robot as a chain in the cell's frame.
struct Arm {
  kinematics::Chain chain;  ///< of the joints that turn
  kinematics::Angles home;
  Ball sphere;  ///< the virtual sphere, in the flange's frame

  /// The frame of the chain with which a link moves, and the link's frame in that; none if the link is fixed.
  struct Carried {
    std::optional<std::size_t> frame;
    Pose pose;
  };
  std::vector<Carried> links;         ///< as in Robot::links; the last one carries the gripper
  std::vector<double> speeds;         ///< of the chain's joints, in degrees per second; 0 where unknown
  std::vector<double> accelerations;  ///< in degrees per second squared; 0 where the speed is there at once

  [[nodiscard]] Ball sphere_at(const kinematics::Angles& commanded) const;
  /// Returns the pose of every link in the cell.
  [[nodiscard]] std::vector<Pose> link_poses(const kinematics::Angles& commanded) const;
};

/// Returns the arm of a cell. Throws BadCell naming the coupling unless a later joint undoes the turning of an earlier
/// one, which no other joint undoes, and both are parallel at home and stay so: joints between them that move or follow
/// others must be parallel to them, too. With other couplings points would not move on arcs.
[[nodiscard]] Arm arm_of(const Cell& cell);

/// The motion of the sphere's centre in the vertical plane that the base turns. The plane may stand beside the base's
/// axis, as the shoulder of a UR5 does.
class PlanarArm {
 public:
  /// Throws BadCell naming `robot.urdf` unless the base turns about z, and shoulder and elbow turn about y with the
  /// sphere's centre at x > 0 at home. Throws BadCell naming `robot.coupling` if a joint behind the elbow undoes the
  /// turning of the elbow but none that of the shoulder.
  PlanarArm(const Cell& cell, const Arm& arm);

  struct Commands {
    double shoulder, elbow;  ///< degrees
  };
  /// Returns the commands, nearest to home, that bring the centre to the given distance from the base's axis and height
  /// above the floor; none if that is out of reach. Ignores joint limits.
  [[nodiscard]] std::optional<Commands> inverse(const kinematics::Reach& center) const;
  /// Returns at least the greatest distance of the centre from the base's axis.
  [[nodiscard]] double furthest() const;
  /// Whether the hand keeps its direction while shoulder and elbow turn.
  [[nodiscard]] bool keeps_level() const { return keeps_level_; }
  /// Returns how far the plane is to the left of the base's axis; 0 if it holds the axis, within 1e-9 of the arm's
  /// length.
  [[nodiscard]] double beside() const { return beside_; }
  /// Returns the direction of the plane, in degrees counter-clockwise, that brings the centre to a direction and a
  /// distance from the base's axis. The directions are equal if the plane holds the axis. A distance below that of the
  /// plane counts as the plane's.
  [[nodiscard]] double facing(double azimuth, double out) const;
  /// Returns the base's command that turns the plane to a direction of the plan, in degrees counter-clockwise.
  [[nodiscard]] double base(double direction) const { return home_base_ + base_sense_ * direction; }

 private:
  [[nodiscard]] double along(double out) const;

  double home_base_, base_sense_, beside_;
  Commands home_;
  kinematics::Reach shoulder_;  // where its axis is
  kinematics::TwoLinks links_;  // to the elbow, and on to the centre or, if the hand stays level, to its joint
  kinematics::Reach hand_;      // from that joint to the centre
  kinematics::LinkAngles home_angles_;
  double shoulder_sense_, elbow_sense_;  // +1 where positive commands lean forward, raise
  bool makes_up_;                        // the elbow, for the shoulder
  bool keeps_level_;
};

}  // namespace touchstone::cell

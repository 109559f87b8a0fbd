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
  std::vector<Carried> links;  ///< as in Robot::links; the last one carries the gripper
  std::vector<double> speeds;  ///< of the chain's joints, in degrees per second; 0 where unknown

  [[nodiscard]] Ball sphere_at(const kinematics::Angles& commanded) const;
  /// Returns the pose of every link in the cell.
  [[nodiscard]] std::vector<Pose> link_poses(const kinematics::Angles& commanded) const;
};

/// Returns the arm of a cell. Throws BadCell naming the coupling unless a later joint undoes the turning of an earlier
/// one, which no other joint undoes, and both are parallel at home and stay so: joints between them that move or follow
/// others must be parallel to them, too. With other couplings points would not move on arcs.
[[nodiscard]] Arm arm_of(const Cell& cell);

/// The motion of the sphere's centre in the vertical plane that the base turns.
class PlanarArm {
 public:
  /// Throws BadCell naming `robot.urdf` unless the base turns about z, shoulder and elbow turn about y, and the
  /// sphere's centre at home is in the plane y = 0 with x > 0 (within 1e-9 of the arm's length). Throws BadCell naming
  /// `robot.coupling` if a joint behind the elbow undoes the turning of the elbow but none that of the shoulder.
  PlanarArm(const Cell& cell, const Arm& arm);

  struct Commands {
    double shoulder, elbow;  ///< degrees
  };
  /// Returns the commands, nearest to home, that bring the centre to the given distance from the base's axis and height
  /// above the floor; none if that is out of reach. Ignores joint limits.
  [[nodiscard]] std::optional<Commands> inverse(const kinematics::Reach& center) const;
  /// Returns the greatest distance of the centre from the base's axis.
  [[nodiscard]] double furthest() const;
  /// Returns the base's command that faces a direction of the plan, in degrees counter-clockwise.
  [[nodiscard]] double base(double azimuth) const { return home_base_ + base_sense_ * azimuth; }

 private:
  double home_base_, base_sense_;
  Commands home_;
  kinematics::Reach shoulder_;  // where its axis is
  kinematics::TwoLinks links_;  // to the elbow, and on to the centre or, if the hand stays level, to its joint
  kinematics::Reach hand_;      // from that joint to the centre
  kinematics::LinkAngles home_angles_;
  double shoulder_sense_, elbow_sense_;  // +1 where positive commands lean forward, raise
  bool makes_up_;                        // the elbow, for the shoulder
};

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/cell/kinematics/chain.h"
#include "experiments/cell/kinematics/two_link.h"
#include "experiments/cell/model/cell.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// The joints that the process moves: the first three that turn. The others stay as they are at home.
enum Moved : std::size_t { kBase, kShoulder, kElbow };

/// A robot as a chain in the cell's frame.
struct Arm {
  kinematics::Chain chain;  ///< of the joints that turn
  kinematics::Angles home;
  Ball sphere;  ///< the virtual sphere, in the flange's frame

  /// Which frame of the chain a link moves with, and where its own stands in that; none: it stands still, there.
  struct Carried {
    std::optional<std::size_t> frame;
    Pose pose;
  };
  std::vector<Carried> links;  ///< as in Robot::links; the last one carries the gripper

  [[nodiscard]] Ball sphere_at(const kinematics::Angles& commanded) const;
  /// Of every link, in the cell.
  [[nodiscard]] std::vector<Pose> link_poses(const kinematics::Angles& commanded) const;
};

/// Throws BadCell naming `robot.coupling` for couplings other than one, of a joint with the next, parallel one, that
/// makes up for its turning: what it carries would not move on arcs.
[[nodiscard]] Arm arm_of(const Cell& cell);

/// The motion of the sphere's centre in the vertical plane that the base turns.
class PlanarArm {
 public:
  /// Throws BadCell naming `robot.urdf` where the base does not turn about z, shoulder and elbow not about y, or the
  /// sphere's centre at home is not in the plane y = 0, on the side of x > 0 (within 1e-9 of the arm's length).
  PlanarArm(const Cell& cell, const Arm& arm);

  struct Commands {
    double shoulder, elbow;  ///< degrees
  };
  /// The commands, nearest to home, that bring the centre so far from the base's axis and so high above the floor;
  /// none where it is out of reach. Joint limits are not looked at.
  [[nodiscard]] std::optional<Commands> inverse(const kinematics::Reach& center) const;
  /// The base's command that faces a direction of the plan, in degrees counter-clockwise.
  [[nodiscard]] double base(double azimuth) const { return home_base_ + base_sense_ * azimuth; }

 private:
  double home_base_, base_sense_;
  Commands home_;
  kinematics::Reach shoulder_;  // where its axis is
  kinematics::TwoLinks links_;
  kinematics::LinkAngles home_angles_;
  double shoulder_sense_, elbow_sense_;  // +1 where positive commands lean forward, raise
  bool makes_up_;                        // the elbow, for the shoulder
};

}  // namespace touchstone::cell

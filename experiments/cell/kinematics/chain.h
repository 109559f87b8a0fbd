// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/first_contact/arc.h"
#include "geometry/shapes/pose.h"

namespace touchstone::kinematics {

/// A revolute joint of a serial arm: its frame stands at `origin` in the frame of the joint before (of the base, the
/// first one), and turns about an axis through its own origin.
struct Joint {
  std::string name;
  Pose origin;             ///< at angle 0
  Eigen::Vector3d axis;    ///< in its own frame, of length 1; turns are right-handed
  double lowest, highest;  ///< degrees that the joint can reach, both included
};

/// A row of a Denavit-Hartenberg table: turn by theta about z, go d along z and a along the new x, turn by alpha about
/// that. Degrees, and the unit of length of the arm.
struct DenavitHartenberg {
  double alpha, a, d;
  double theta;  ///< where the joint's angle is 0
};
/// What a row's link does at that theta.
[[nodiscard]] Pose link_of(const DenavitHartenberg& row);

/// Commanded angles, one a joint, in degrees.
using Angles = std::vector<double>;

/// A serial chain of revolute joints, each turned by what it is commanded.
///
/// One joint may be a driver, for whose turning the next one makes up, as parallel bars or belts do: it turns by as
/// much against it, so that what comes behind is shifted, but not turned.
class Chain {
 public:
  /// `flange` is its frame in that of the last joint. Throws std::invalid_argument, naming the joint: a number that is
  /// not finite, an axis that is not of length 1 (within 1e-12), limits the wrong way round, or a driver that is not
  /// parallel to a next joint.
  Chain(std::vector<Joint> joints, Pose flange, std::optional<std::size_t> driver = {});

  [[nodiscard]] const std::vector<Joint>& joints() const& { return joints_; }
  void joints() && = delete;  // a reference into a chain that is gone
  /// The joint of that name. Throws std::invalid_argument where there is none.
  [[nodiscard]] std::size_t find(const std::string& name) const;

  /// By how much each joint turns: what it is commanded, and what makes up for the driver. Throws std::invalid_argument
  /// where there is not one angle a joint.
  [[nodiscard]] Angles turns(const Angles& commanded) const;
  /// Throws std::out_of_range, which names the joint and its limits, where one turns beyond them, or by what is not a
  /// number; and as above.
  void require_reachable(const Angles& commanded) const;

  /// By how many degrees a joint can be commanded further, up or down, until it or what makes up for it is at a limit;
  /// negative beyond one. Throws as turns does.
  [[nodiscard]] double room(const Angles& commanded, std::size_t joint, bool up) const;

  /// The frames of the joints, in that of the base, then that of the flange. Doubles: off by some 1e-15 of the arm's
  /// length; the same bits on every machine. Limits are not looked at. Throws as turns does.
  [[nodiscard]] std::vector<Pose> frames(const Angles& commanded) const;
  /// Where a point of the flange's frame stands.
  [[nodiscard]] Eigen::Vector3d place(const Angles& commanded, const Eigen::Vector3d& point) const;

  /// The way of a point of the flange's frame while one joint is moved by so many degrees: an arc about that joint's
  /// axis, or where it is the driver, about a parallel one. Throws std::out_of_range where the move begins or ends
  /// beyond a limit, std::invalid_argument for a move of more than 360 degrees.
  [[nodiscard]] Arc arc(const Angles& commanded, std::size_t joint, double move, const Eigen::Vector3d& point) const;

 private:
  std::vector<Joint> joints_;
  Pose flange_;
  std::optional<std::size_t> driver_;
  double factor_ = 0;  // of the driver's angle, in the next joint's
};

}  // namespace touchstone::kinematics

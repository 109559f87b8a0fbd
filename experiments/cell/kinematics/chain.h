// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cell/first_contact/arc.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// A revolute joint and the link behind it, after Denavit and Hartenberg: the joint turns by theta about z, then the
/// link goes d along z, a along the new x, and turns by alpha about that.
///
/// A joint is commanded by an angle of its own, 0 where theta is `zero`; `sense` is +1 where both grow together, else
/// -1. Angles in degrees, lengths in metres.
struct Joint {
  std::string name;
  double alpha, a, d, zero;
  int sense;
  double lowest, highest;  ///< commands that the joint can reach, both included
};

/// Commanded angles, one a joint, in degrees.
using Angles = std::vector<double>;

/// A serial chain of revolute joints.
///
/// One joint may be a driver, whose turning the next joint makes up for, as parallel bars or belts do: what comes
/// behind the next joint is then shifted, but not turned, where the driver turns.
class Chain {
 public:
  /// Throws std::invalid_argument, naming the joint: a number that is not finite, a sense other than +-1, limits the
  /// wrong way round, or a driver that is the last joint or not parallel to the next.
  explicit Chain(std::vector<Joint> joints, std::optional<std::size_t> driver = {});

  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  /// The joint of that name. Throws std::invalid_argument where there is none.
  [[nodiscard]] std::size_t find(const std::string& name) const;

  /// Throws std::out_of_range, which names the joint and its limits, where an angle is beyond them, or not a number;
  /// std::invalid_argument where there is not one angle a joint.
  void require_reachable(const Angles& angles) const;

  /// The frames of the links, in the frame of the base: frame 0 is that one, joint i turns about z of frame i, the last
  /// is the flange. Doubles: off by some 1e-15 of the arm's length; the same bits on every machine. Limits are not
  /// looked at. Throws as above where there is not one angle a joint.
  [[nodiscard]] std::vector<Pose> frames(const Angles& angles) const;
  /// Where a point of the flange's frame stands.
  [[nodiscard]] Eigen::Vector3d place(const Angles& angles, const Eigen::Vector3d& point) const;

  /// The way of a point of the flange's frame while one joint turns by `move` degrees. Throws std::out_of_range where
  /// the move begins or ends beyond the joint's limits, and std::invalid_argument for a move of more than 360 degrees.
  [[nodiscard]] Arc arc(const Angles& angles, std::size_t joint, double move, const Eigen::Vector3d& point) const;

 private:
  std::vector<Joint> joints_;
  std::optional<std::size_t> driver_;
};

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "experiments/thesis/cell/simulation/arm.h"

namespace touchstone::cell {

/// How the links of an arm move while one joint turns: not at all, about the joint's axis or, behind a joint that makes
/// up for the turning, along arcs without turning.
class JointTurn {
 public:
  static constexpr double kGenerous = 1 + 1e-9;  ///< more than the roundings of a few lengths add up to

  /// Without a joint the arm is at rest. Requires an arm that outlives it.
  JointTurn(const Arm& arm, const kinematics::Angles& from, std::optional<Moved> joint);

  enum class Motion { None, Turned, Shifted };
  [[nodiscard]] Motion motion(std::size_t link) const;
  /// Returns a length that no point of a ball, which moves so, leaves behind while the joint turns by `degrees`.
  [[nodiscard]] double moved(Motion motion, const Eigen::Vector3d& center, double radius, double degrees) const;

  [[nodiscard]] const Eigen::Vector3d& axis() const { return axis_; }
  [[nodiscard]] const Eigen::Vector3d& on_axis() const { return on_axis_; }
  /// A point along whose arc is shifted what is shifted; none if nothing is.
  [[nodiscard]] const std::optional<Eigen::Vector3d>& pivot() const { return pivot_; }

 private:
  [[nodiscard]] double from_axis(const Eigen::Vector3d& point) const { return axis_.cross(point - on_axis_).norm(); }

  const Arm* arm_;
  std::optional<Moved> joint_;
  Eigen::Vector3d on_axis_ = Eigen::Vector3d::Zero(), axis_ = Eigen::Vector3d::UnitZ();
  std::optional<std::size_t> shifted_from_;  // the frames from that of this joint on are shifted, not turned
  std::optional<Eigen::Vector3d> pivot_;
  double shift_ = 0;  // the radius of the arc along which they are
};

}  // namespace touchstone::cell

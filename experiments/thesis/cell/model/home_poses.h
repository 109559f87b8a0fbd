// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "experiments/thesis/cell/model/cell.h"
#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// Returns the pose of a frame that is at `pose` in a frame at `outer`.
[[nodiscard]] Pose within(const Pose& outer, const Pose& pose);
[[nodiscard]] Pose inverse(const Pose& pose);
/// Returns the rotation about an axis of length 1, right-handed.
[[nodiscard]] Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees);

/// Returns the angle of a joint about its axis at home: its command and what it takes from those that it follows.
[[nodiscard]] double angle_at_home(const Robot& robot, std::size_t joint);
/// Returns the pose of every link at home, in the robot's frame.
[[nodiscard]] std::vector<Pose> home_poses(const Robot& robot);

}  // namespace touchstone::cell

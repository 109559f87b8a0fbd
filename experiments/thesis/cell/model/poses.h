// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "geometry/shapes/pose.h"

namespace touchstone::cell {

/// Returns the pose of a frame that is at `pose` in a frame at `outer`.
[[nodiscard]] Pose within(const Pose& outer, const Pose& pose);
[[nodiscard]] Pose inverse(const Pose& pose);
/// Returns the angle in degrees by which the rotations of two poses differ.
[[nodiscard]] double turn_between(const Pose& one, const Pose& other);

/// Returns the rotation about an axis of length 1, right-handed.
[[nodiscard]] Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees);
/// Returns the matrix of a counter-clockwise turn by `quarters` quarter turns about a coordinate axis (0, 1 or 2): its
/// entries are 0, 1 and -1.
[[nodiscard]] Eigen::Matrix3d quarter_turns(int axis, int quarters);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/model/poses.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/degrees.h"

namespace touchstone::cell {

Pose within(const Pose& outer, const Pose& pose) { return {outer.rotation * pose.rotation, outer * pose.translation}; }

Pose inverse(const Pose& pose) {
  const Eigen::Matrix3d back = pose.rotation.transpose();
  return {back, -(back * pose.translation)};
}

double turn_between(const Pose& one, const Pose& other) {
  const double chord = (one.rotation - other.rotation).norm() / (2 * std::sqrt(2.0));
  return 2 * workloads::arc_sine(std::min(1.0, chord));
}

// Rodrigues' formula.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double degrees) {
  const double c = workloads::cosine(degrees), s = workloads::sine(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(),  //
      axis.z(), 0, -axis.x(),       //
      -axis.y(), axis.x(), 0;
  return c * Eigen::Matrix3d::Identity() + s * cross + (1 - c) * (axis * axis.transpose());
}

Eigen::Matrix3d quarter_turns(int axis, int quarters) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), quarter = Eigen::Matrix3d::Zero();
  quarter(axis, axis) = 1;
  quarter(v, u) = 1;
  quarter(u, v) = -1;
  for (int i = 0; i < (quarters % 4 + 4) % 4; ++i) turn = quarter * turn;
  return turn;
}

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace touchstone::cell {

/// Returns the matrix of a counter-clockwise turn by `quarters` quarter turns about a coordinate axis (0, 1 or 2): its
/// entries are 0, 1 and -1.
[[nodiscard]] inline Eigen::Matrix3d quarter_turns(int axis, int quarters) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), quarter = Eigen::Matrix3d::Zero();
  quarter(axis, axis) = 1;
  quarter(v, u) = 1;
  quarter(u, v) = -1;
  for (int i = 0; i < (quarters % 4 + 4) % 4; ++i) turn = quarter * turn;
  return turn;
}

}  // namespace touchstone::cell

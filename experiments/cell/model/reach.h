// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "experiments/cell/model/cell.h"

namespace touchstone::cell {

/// Where the process can have the arm hold the centre of its sphere: at a distance from `inner` to `outer` from some
/// point of the circle about the cell's z axis on which the second joint's origin lies. Its first three joints that
/// turn move, and joints that follow others; the others stay as they are at home.
///
/// Joint limits and the directions of axes are not looked at: what this leaves out is out of reach, but not all that it
/// leaves in is within.
struct Reach {
  double radius, height;  ///< of the circle
  double inner, outer;

  /// Of a point of the cell from the nearest point of the circle.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;
};

[[nodiscard]] Reach reach_of(const Cell& cell);

/// Throws BadCell naming `storage.radius` or `machine.radius` where the sphere cannot touch a ball around the material
/// in one of the station's slots: too near or too far, by which number, and at which radii the arm reaches all
/// slots from above, joint limits and obstacles apart. To be called again
/// where a cell is changed after it was read.
void check_reach(const Cell& cell);

}  // namespace touchstone::cell

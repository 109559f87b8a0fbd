// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "experiments/thesis/cell/model/cell.h"

namespace touchstone::cell {

/// The region in which the arm can hold the centre of its sphere during the process. The first joint turns a vertical
/// plane about the cell's z axis, in which the centre moves. Projected into it, the centre is `inner` to `outer` away
/// from the second joint or, if the hand stays level, from that joint shifted by what the sphere hangs from the hand's
/// joint. Only the first three joints that turn and the joints that follow others move; all other joints stay as they
/// are at home.
///
/// Ignores joint limits and the directions of axes, so it is a necessary condition only: points outside the region are
/// out of reach, points inside may be out of reach, too.
struct Reach {
  double beside;          ///< the distance of the plane from the axis
  double radius, height;  ///< of the second joint, so projected and shifted: how far ahead of the axis, and how high
  double inner, outer;
  double shift;  ///< how far the second joint is shifted

  /// Returns the greatest distance of the centre from the cell's z axis.
  [[nodiscard]] double furthest() const;

  /// Returns the distance of a point of the cell from the circle on which the first joint turns that place.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;
};

[[nodiscard]] Reach reach_of(const Cell& cell);

/// Returns what is wrong if the sphere cannot touch a ball around the material in one of a station's slots, as in
/// `storage.radius: too far: ...`: the distance, whether it is too near or too far, and the radii at which the arm
/// reaches all slots from above, joint limits and obstacles apart.
[[nodiscard]] std::optional<std::string> reach_fault(const Cell& cell);

}  // namespace touchstone::cell

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "experiments/thesis/cell/model/cell.h"

namespace touchstone::cell {

/// The region in which the arm can hold the centre of its sphere during the process: at a distance from `inner` to
/// `outer` from some point of the circle about the cell's z axis on which the second joint's origin lies; if the hand
/// stays level, of that circle shifted by what the sphere hangs from the hand's joint. Only the first three joints that
/// turn and the joints that follow others move; all other joints stay as they are at home.
///
/// Ignores joint limits and the directions of axes, so it is a necessary condition only: points outside the region are
/// out of reach, points inside may be out of reach, too.
struct Reach {
  double radius, height;  ///< of the circle
  double inner, outer;

  /// Returns the distance of a point of the cell from the nearest point of the circle.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;
};

[[nodiscard]] Reach reach_of(const Cell& cell);

/// Returns what is wrong if the sphere cannot touch a ball around the material in one of a station's slots, as in
/// `storage.radius: too far: ...`: the distance, whether it is too near or too far, and the radii at which the arm
/// reaches all slots from above, joint limits and obstacles apart.
[[nodiscard]] std::optional<std::string> reach_fault(const Cell& cell);

}  // namespace touchstone::cell

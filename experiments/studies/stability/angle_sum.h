// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "experiments/studies/stability/outlines.h"

namespace touchstone::stability {

/// What step (3) of the thesis's method adds up around a point: the angles, in degrees, at which the edges are seen.
struct AngleSum {
  std::vector<double> angles;  ///< of each edge, negative where it is seen turning clockwise
  double unsigned_sum = 0, signed_sum = 0;
};
/// In doubles, by atan2: to some 1e-13. Requires a point in the plane z = 0.
[[nodiscard]] AngleSum angle_sum(const Outline& outline, const Eigen::Vector3d& point);

/// Of a U: a point between the end of its gap and its back, and one between that end and the gap's mouth, where the
/// mouth is at the bottom. Requires two corners at which the outline turns clockwise.
struct GripperPoints {
  Eigen::Vector3d palm, gap;
};
[[nodiscard]] GripperPoints gripper_points(const Outline& outline);

/// A point of a map of the plane around an outline.
struct MapPoint {
  double x, y, sum;     ///< unsigned, degrees
  bool inside, called;  ///< exactly, and by the thesis's method
};
/// Centres of so many squares along the longer side of the bounding box, enlarged on each side by half its extent; row
/// by row from the bottom.
struct AngleMap {
  Box box;
  std::size_t columns, rows;
  std::vector<MapPoint> points;
};
[[nodiscard]] AngleMap map_angle_sums(const Outline& outline, std::size_t along);

}  // namespace touchstone::stability

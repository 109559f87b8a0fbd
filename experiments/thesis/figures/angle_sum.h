// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "experiments/thesis/figures/outlines.h"

namespace touchstone::figures {

/// The angles, in degrees, at which the edges are seen from a point. Step (3) of the thesis's method sums their
/// magnitudes.
struct AngleSum {
  std::vector<double> angles;  ///< for each edge, negative if it is seen turning clockwise
  double unsigned_sum = 0, signed_sum = 0;
};
/// Computes the angles in doubles, by atan2, to about 1e-13. Requires a point in the plane z = 0.
[[nodiscard]] AngleSum angle_sum(const Outline& outline, const Eigen::Vector3d& point);

/// Returns two points of a U with the mouth of its gap at the bottom: one between the end of the gap and the U's back,
/// one between that end and the mouth. Requires two corners at which the outline turns clockwise.
struct GripperPoints {
  Eigen::Vector3d palm, gap;
};
[[nodiscard]] GripperPoints gripper_points(const Outline& outline);

/// A point of a map of the plane around an outline.
struct MapPoint {
  double x, y, sum;     ///< unsigned, degrees
  bool inside, called;  ///< inside exactly, and according to the thesis's method
};
/// Computes a map at the centres of squares that tile the bounding box, enlarged on each side by half its extent, with
/// the given number of squares along the longer side; row by row from the bottom.
struct AngleMap {
  Box box;
  std::size_t columns, rows;
  std::vector<MapPoint> points;
};
[[nodiscard]] AngleMap map_angle_sums(const Outline& outline, std::size_t along);

}  // namespace touchstone::figures

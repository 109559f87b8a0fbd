// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/thesis/cell/simulation/triangle_tree.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::cell {

/// An enclosure of a distance: `lower` is proved, `upper` is attained by two points, up to their rounding.
struct DistanceBounds {
  double lower, upper;
};

/// Returns the distance of two closed triangles, points and segments among them.
///
/// The lower bound is that of projections onto the line through the two nearest points found, less than what they can
/// be rounded by: no point of one triangle is nearer to the other. It differs from the upper one by rounding, or is 0
/// for triangles that touch. Requires finite coordinates. Cost: 0.3 us.
[[nodiscard]] DistanceBounds distance(const Triangle& first, const Triangle& second);

/// The distance of two sets of triangles.
struct DistanceOfTrees : DistanceBounds {
  std::uint32_t owner = 0, other = 0;  ///< of the two triangles with the least lower bound, if that is below the cutoff
};

/// Returns the distance of posed triangles from others. Both bounds are enlarged by more than posing is off. Distances
/// of `cutoff` and more need not be told apart: then `lower` is the cutoff and `upper` may be infinite. Cost: 5 to 50
/// us, by two hierarchies.
[[nodiscard]] DistanceOfTrees distance(const TriangleTree& moving, const Pose& pose, const TriangleTree& still,
                                       double cutoff);

}  // namespace touchstone::cell

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"

namespace touchstone {

/// A closed triangle: a polygon that needs no preparation. Edge i runs from vertex i to the next.
///
/// A triangle whose vertices lie on one line, equal ones among them, is *degenerate*: it is the segment or the point
/// that they span, has edges and vertices as its features, and neither face nor front. Coordinates are exact real
/// numbers. Requires finite coordinates and, in `fast`, a triangle that is not degenerate. The contact functions do not
/// check this; debug builds assert that coordinates are finite.
struct Triangle {
  /// @{
  /// Vertices 0, 1 and 2.
  Eigen::Vector3d a, b, c;
  /// @}
};

/// The treatment of degenerate triangles by sets and scenes: they are refused, or taken as segments and points.
enum class Degenerate { Refuse, AsSegments };

}  // namespace touchstone

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"
#include "triangle.h"

namespace touchstone {

/// A closed segment from a to b, or a point if they are equal: the degenerate triangle (a, b, b), as which all
/// functions that take a triangle take it. Vertex 0 is a, vertex 1 is b, and edge 0 is the segment between them.
///
/// Coordinates are exact real numbers. Requires finite coordinates.
struct Segment {
  /// @{
  /// The ends.
  Eigen::Vector3d a, b;
  /// @}

  /// Returns the triangle (a, b, b).
  operator Triangle() const { return {a, b, b}; }  // NOLINT: it is a triangle
};

}  // namespace touchstone

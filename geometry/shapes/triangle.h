// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"

namespace touchstone {

/// The closed triangle of three vertices, edge i from vertex i to the next: a polygon that needs no preparation.
///
/// Coordinates are exact real numbers. Requires finite coordinates and vertices that are not collinear: what
/// `exact::validate` accepts of the polygon with these three vertices. The contact functions do not look again; a debug
/// build asserts what geometry/detail/required.h says.
struct Triangle {
  /// @{
  /// Vertices 0, 1 and 2.
  Eigen::Vector3d a, b, c;
  /// @}
};

}  // namespace touchstone

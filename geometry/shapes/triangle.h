// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"

namespace touchstone {

/// A closed triangle: a polygon that needs no preparation. Edge i runs from vertex i to the next.
///
/// Coordinates are exact real numbers. Requires finite coordinates and vertices that are not collinear, so that
/// `exact::validate` would accept the polygon with these vertices. The contact functions do not check this; debug
/// builds assert that coordinates are finite.
struct Triangle {
  /// @{
  /// Vertices 0, 1 and 2.
  Eigen::Vector3d a, b, c;
  /// @}
};

}  // namespace touchstone

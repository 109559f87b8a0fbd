// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"

namespace touchstone {

/// A supporting plane: the points x with normal.(x - point) = 0; the front is the side that the normal points to.
///
/// The normal need not have length 1: unit normals cost a root and a rounding that no test needs.
template <class Scalar>
struct Plane {
  Eigen::Matrix<Scalar, 3, 1> normal;  ///< not zero
  Eigen::Matrix<Scalar, 3, 1> point;   ///< any one of the plane
};

/// The axis of the component of largest magnitude, the lowest on a tie: the coordinate to drop when points of a plane
/// with this normal are projected to two dimensions. Exact for a given normal; call it in the default state of the
/// floating-point unit.
template <class Scalar>
[[nodiscard]] int dropped_axis(const Eigen::Matrix<Scalar, 3, 1>& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace touchstone

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"

namespace touchstone {

/// A supporting plane: the points x with normal.(x - point) = 0. The normal points to its front.
///
/// The normal need not have length 1: to normalise it would cost a root and a rounding that no test needs.
template <class Scalar>
struct Plane {
  Eigen::Matrix<Scalar, 3, 1> normal;  ///< not zero
  Eigen::Matrix<Scalar, 3, 1> point;   ///< any point of the plane
};

/// Returns the axis of the normal's component of largest magnitude, the lowest on a tie: the coordinate to drop when
/// projecting the plane to two dimensions. Exact for the given normal. Call it in the default state of the
/// floating-point unit.
template <class Scalar>
[[nodiscard]] int dropped_axis(const Eigen::Matrix<Scalar, 3, 1>& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace touchstone

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"
#include "../same_number.h"

namespace touchstone {

/// Where an object stands: what its model calls p is at R p + t, in one unit of length. The identity by default.
///
/// R and t are exact real numbers. R is meant to be a rotation but need not be orthogonal to the last bit, nor at all:
/// what is said of posed vertices holds for every matrix. Requires finite numbers.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< R
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();   ///< t

  /// Number by number (0 = -0).
  friend bool operator==(const Pose& a, const Pose& b) {
    for (int column = 0; column < 3; ++column)
      if (!same_point(a.rotation.col(column), b.rotation.col(column))) return false;
    return same_point(a.translation, b.translation);
  }
};

}  // namespace touchstone

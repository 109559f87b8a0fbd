// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../floating_point.h"
#include "../same_number.h"

namespace touchstone {

/// A rotation R and a translation t: the point p of a model lies at R p + t. The identity by default.
///
/// R and t are exact real numbers. R should be a rotation, but all guarantees about posed vertices hold for every
/// matrix, orthogonal or not. Requires finite numbers.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< R
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();   ///< t

  /// Returns whether all numbers are the same (0 = -0).
  friend bool operator==(const Pose& a, const Pose& b) {
    for (int column = 0; column < 3; ++column)
      if (!same_point(a.rotation.col(column), b.rotation.col(column))) return false;
    return same_point(a.translation, b.translation);
  }

  /// Returns R p + t in doubles: where the point p of the model lies, up to rounding. `scene::posed` rounds correctly.
  /// Call it in the default state of the floating-point unit: it is too short to set that state itself.
  friend Eigen::Vector3d operator*(const Pose& pose, const Eigen::Vector3d& p) {
    return pose.rotation * p + pose.translation;
  }
};

}  // namespace touchstone

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "robust/filtered/detail/newell_sums.h"
#include "robust/filtered/detail/vector3.h"

namespace touchstone::filtered {

/// The supporting plane of a polygon in double-doubles, without integers of any size.
struct NewellPlane {
  /// The most by which `normal` may differ from the exact one, in units of its largest component.
  static constexpr double kError = 0x1p-60;

  Vector3<DoubleDouble> normal;  ///< the Newell normal of the outer loop, each component to kError of the largest one
  Vector3<DoubleDouble> mean;    ///< the mean of the outer loop's vertices, from vertex 0
  int dropped_axis;              ///< as in the contract: the first axis with the largest component of the normal
  /// Whether `normal` and `dropped_axis` are as described, and the normal is larger than kSmallest. If not, exact
  /// arithmetic must tell.
  bool certain;

  /// The plane of a loop with these sums. Requires round to nearest.
  NewellPlane(const NewellSums& sums, std::span<const ScaledVertex> loop);

  /// The smallest largest component of a normal in a frame: squares of it and of smaller ones do not underflow.
  static constexpr double kSmallest = 0x1p-400;
  /// Takes a normal that was rounded from exact numbers. Then the plane is certain, unless the normal is too small.
  void take_exact(const Vector3<DoubleDouble>& rounded_normal, int exact_dropped_axis);
};

}  // namespace touchstone::filtered

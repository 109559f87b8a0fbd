// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  /// Whether `normal` and `dropped_axis` are as described. If not, only exact arithmetic can tell them.
  bool certain;

  /// The plane of a loop of `count` vertices with these sums. Requires round to nearest.
  NewellPlane(const NewellSums& sums, std::size_t count);
};

}  // namespace touchstone::filtered

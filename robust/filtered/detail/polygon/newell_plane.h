// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "robust/filtered/detail/numbers/vector3.h"
#include "robust/filtered/detail/polygon/newell_sums.h"

namespace touchstone::filtered::detail {

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

/// Returns the axis of the largest component of a loop's Newell normal, the lowest on a tie, decided in integers of
/// fixed width; nothing if a coordinate from vertex 0 is not a multiple of 2^-127.
///
/// Requires at most EdgeTree::kMostEdges vertices, within 1/4 of vertex 0 in each coordinate, and round to nearest.
/// Cost: linear; 10 ns per vertex if all coordinates from vertex 0 are multiples of 2^-63, else 0.2 us.
[[nodiscard]] std::optional<int> exact_dropped_axis(std::span<const ScaledVertex> loop);

}  // namespace touchstone::filtered::detail

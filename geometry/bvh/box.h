// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "geometry/floating_point.h"
#include "geometry/shapes/triangle.h"

namespace touchstone {

/// The closed box of all points between two corners, coordinate by coordinate; empty if low > high in some coordinate.
///
/// Call its functions in the default state of the floating-point unit: they are too short to set that state themselves.
struct Box {
  /// The corner with the smallest coordinates.
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  /// The corner with the largest coordinates.
  Eigen::Vector3d high = -low;

  /// Returns whether the box contains no point.
  [[nodiscard]] bool empty() const { return (low.array() > high.array()).any(); }
  /// Returns the smallest box that contains both.
  [[nodiscard]] Box joined(const Box& other) const { return {low.cwiseMin(other.low), high.cwiseMax(other.high)}; }
};

/// Returns whether some point is in both boxes.
[[nodiscard]] inline bool meet(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}
/// Returns the smallest box that contains the triangle; exact.
[[nodiscard]] inline Box box(const Triangle& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}
/// Returns the smallest box that contains all triangles, the empty box if there are none; exact.
[[nodiscard]] inline Box box(std::span<const Triangle> triangles) {
  Box all;
  for (const Triangle& t : triangles) all = all.joined(box(t));
  return all;
}

}  // namespace touchstone

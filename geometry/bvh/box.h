// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>

#include "geometry/floating_point.h"
#include "geometry/shapes/triangle.h"

namespace touchstone {

/// The closed box of all points between two corners, coordinate by coordinate; empty where low > high.
///
/// Call what compares boxes' coordinates in the default state of the floating-point unit: it is too small a thing to
/// set that state by itself.
struct Box {
  /// The corner of the least coordinates.
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  /// The corner of the largest ones.
  Eigen::Vector3d high = -low;

  /// Is there no point in it?
  [[nodiscard]] bool empty() const { return (low.array() > high.array()).any(); }
  /// The smallest box that holds both.
  [[nodiscard]] Box joined(const Box& other) const { return {low.cwiseMin(other.low), high.cwiseMax(other.high)}; }
};

/// The smallest box that holds the triangle; exact.
[[nodiscard]] inline Box box(const Triangle& t) {
  return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

}  // namespace touchstone

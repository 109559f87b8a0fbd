// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace touchstone::workloads {

/// The finite double nearest to x: what has overflowed becomes the largest of its sign. Requires that x is no NaN.
[[nodiscard]] inline double finite(double x) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(x, -kLargest, kLargest);
}

/// Coordinate by coordinate.
[[nodiscard]] inline Eigen::Vector3d finite(const Eigen::Vector3d& point) {
  return {finite(point.x()), finite(point.y()), finite(point.z())};
}

}  // namespace touchstone::workloads

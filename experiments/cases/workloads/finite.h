// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace touchstone::workloads {

/// Returns the finite double nearest to x; an overflow becomes the largest double of its sign. Requires that x is not a
/// NaN.
[[nodiscard]] inline double finite(double x) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(x, -kLargest, kLargest);
}

/// The same for each coordinate.
[[nodiscard]] inline Eigen::Vector3d finite(const Eigen::Vector3d& point) {
  return {finite(point.x()), finite(point.y()), finite(point.z())};
}

}  // namespace touchstone::workloads

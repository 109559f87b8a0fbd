// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

/// All functions here are exact for finite doubles. They require round to nearest, without flush-to-zero.
namespace touchstone::exact {

/// Returns whether the point p lies to the left of (1), on (0) or to the right of (-1) the directed line from a to b.
[[nodiscard]] int orientation(double ax, double ay, double bx, double by, double px, double py);

/// Returns whether a plane holds all four points.
[[nodiscard]] bool coplanar(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                            const Eigen::Vector3d& d);

}  // namespace touchstone::exact

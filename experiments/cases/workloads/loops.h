// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::workloads {

/// Returns the loops of a polygon, the outer one first.
[[nodiscard]] std::vector<Loop> loops_of(const Polygon& polygon);
/// Returns the largest difference of a coordinate of two vertices.
[[nodiscard]] double extent_of(const Polygon& polygon);
/// Returns the Newell normal of a loop, rounded.
[[nodiscard]] Eigen::Vector3d normal_of(const Polygon& polygon, std::size_t loop);
/// Returns the polygon of these loops. Throws Rejected if neighbouring vertices are equal or a number is not finite.
[[nodiscard]] Polygon polygon_of(const std::vector<Loop>& loops);

}  // namespace touchstone::workloads

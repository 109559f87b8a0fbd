// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::workloads {

/// Returns the loops of a polygon, the outer one first.
[[nodiscard]] inline std::vector<Loop> loops_of(const Polygon& polygon) {
  std::vector<Loop> loops(polygon.loop_count());
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
      loops[loop].push_back(polygon.vertex(i));
  return loops;
}

/// Returns the largest difference of a coordinate of two vertices.
[[nodiscard]] inline double extent_of(const Polygon& polygon) {
  Eigen::Vector3d low = polygon.vertex(0), high = low;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i) {
    low = low.cwiseMin(polygon.vertex(i));
    high = high.cwiseMax(polygon.vertex(i));
  }
  return (high - low).maxCoeff();
}

/// Returns the Newell normal of a loop, rounded.
[[nodiscard]] inline Eigen::Vector3d normal_of(const Polygon& polygon, std::size_t loop) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.vertex(polygon.loop_begin(loop));
  for (std::size_t i = polygon.loop_begin(loop); i < polygon.loop_end(loop); ++i)
    normal += (polygon.vertex(i) - origin).cross(polygon.vertex(polygon.next(i)) - origin);
  return normal;
}

/// Returns the polygon of these loops. Throws Rejected if neighbouring vertices are equal or a number is not finite.
[[nodiscard]] inline Polygon polygon_of(const std::vector<Loop>& loops) {
  return Polygon(loops[0], {loops.begin() + 1, loops.end()});
}

}  // namespace touchstone::workloads

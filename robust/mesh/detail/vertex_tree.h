// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh/box_tree.h"

namespace touchstone::mesh::detail {

/// Finds the vertices of a welded mesh on a line segment. Requires round to nearest, without flush-to-zero.
class VertexTree {
 public:
  /// Requires points that are all different. They are not copied. Leaves out those that are not finite. Cost: that of
  /// BoxTree.
  explicit VertexTree(std::span<const Eigen::Vector3d> points);

  /// Returns the numbers of the points strictly between points a and b, which must be finite, on the way from a to b.
  /// Exact. Cost: O(log n) nodes of a tree and about 10 ns per point near the segment, unless the points are spread
  /// along it.
  [[nodiscard]] std::vector<std::uint32_t> between(std::uint32_t a, std::uint32_t b) const;

 private:
  VertexTree(std::span<const Eigen::Vector3d> points, std::vector<std::uint32_t> finite);

  std::span<const Eigen::Vector3d> points_;
  std::vector<std::uint32_t> finite_;
  BoxTree tree_;  ///< over the finite points
};

}  // namespace touchstone::mesh::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchstone::filtered {

/// A hierarchy of boxes over the edges of loops in the plane.
///
/// Every node stands for a chain of consecutive edges of one loop, or for whole loops. The horizontal line through a
/// point meets a box that the point is not in on one side of it only: so the ray to the right crosses the chain in that
/// box an odd number of times exactly where the box is met on the right and the chain's two ends lie on different sides
/// of the ray. Only chains whose box is near the point need a closer look, for distances and for inside or outside
/// alike. Boxes are turned with their chains, so that spikes have thin ones. Four children a node and four edges a
/// leaf, as structure of arrays.
class ChainTree {
 public:
  static constexpr std::size_t kWidth = 4;

  struct Edge {
    double start_x, start_y, end_x, end_y;    ///< as rounded
    double direction_x, direction_y, length;  ///< of the exact edge, each rounded once; the direction has length 1
  };

  /// Consecutive edges of one loop. Lanes from `count` on repeat the end of the last one as an edge of length 0.
  struct Leaf {
    alignas(32) double start_x[kWidth];
    double start_y[kWidth], end_x[kWidth], end_y[kWidth], direction_x[kWidth], direction_y[kWidth], length[kWidth];
    std::uint32_t first_edge, count;
  };

  /// Boxes and ends of up to four chains; those that are not there have a box that is far from everything.
  struct Node {
    alignas(32) double center_x[kWidth];
    double center_y[kWidth], axis_x[kWidth], axis_y[kWidth];  ///< the axis has length 1, but for rounding
    double half_along[kWidth], half_across[kWidth];           ///< of the box, rounding included
    double first_y[kWidth], last_y[kWidth];                   ///< of the chain's ends; equal for whole loops
    std::uint32_t first_vertex[kWidth], last_vertex[kWidth];
    std::int32_t child[kWidth];  ///< a node, or ~leaf
  };

  /// `loop_ends[l]` is one past the last edge of loop l. Cost: O(n log n).
  ChainTree(std::span<const Edge> edges, std::span<const std::size_t> loop_ends);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }
  /// The node above all others.
  [[nodiscard]] std::int32_t root() const { return root_; }
  /// The most nodes and leaves that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 96;

 private:
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::int32_t root_;
};

}  // namespace touchstone::filtered

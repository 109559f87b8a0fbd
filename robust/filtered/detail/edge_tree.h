// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchstone::filtered {

/// A hierarchy of boxes over the edges of loops in the plane, for distances and for inside or outside alike.
///
/// Every node stands for edges that lie near each other. Its ends are the vertices that only one of them has. The
/// horizontal line through a point meets a box that the point is not in on one side of it only: so the ray to the right
/// crosses the edges in that box an odd number of times exactly where the box is met on the right and the number of
/// ends above the ray is odd. Only boxes near the point need a closer look. Boxes are turned with what is in them, so
/// that spikes have thin ones. Four children a node and four edges a leaf, as structure of arrays.
class EdgeTree {
 public:
  static constexpr std::size_t kWidth = 4;
  static constexpr std::size_t kMostEdges = std::size_t{1} << 26;

  struct Edge {
    double start_x, start_y, end_x, end_y;    ///< as rounded
    double direction_x, direction_y, length;  ///< of the exact edge, each rounded once; the direction has length 1
  };

  /// Lanes from `count` on hold an end of the last edge as an edge of length 0.
  struct Leaf {
    alignas(32) double start_x[kWidth];
    double start_y[kWidth], end_x[kWidth], end_y[kWidth], direction_x[kWidth], direction_y[kWidth], length[kWidth];
    std::uint32_t edge[kWidth];
    std::uint32_t count;
  };

  /// Boxes and ends of up to four groups of edges; those that are not there have a box that is far from everything.
  struct Node {
    alignas(32) double center_x[kWidth];
    double center_y[kWidth], axis_x[kWidth], axis_y[kWidth];  ///< the axis has length 1, but for rounding
    double half_along[kWidth], half_across[kWidth];           ///< of the box, and bounds::kBoxRounding
    double lowest_end[kWidth], highest_end[kWidth];           ///< y of the ends; equal where there are none
    std::uint32_t ends[kWidth], end_count[kWidth];            ///< where they are stored, and how many
    std::int32_t child[kWidth];                               ///< a node, or ~leaf
    std::uint32_t with_more_ends;                             ///< a bit a group: it has more than two
  };

  struct End {
    double y;
    std::uint32_t vertex;
    friend auto operator<=>(const End&, const End&) = default;  // NOLINT(modernize-use-nullptr)
  };

  /// `loop_ends[l]` is one past the last edge of loop l. Requires at most kMostEdges edges. Cost: O(n log n); memory:
  /// O(n log n) for loops that wind through every part of the plane, O(n) where near edges follow each other.
  EdgeTree(std::span<const Edge> edges, std::span<const std::size_t> loop_ends);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }
  /// The ends of a group of a node, by y.
  [[nodiscard]] std::span<const End> ends_of(const Node& node, std::size_t group) const {
    return {ends_.data() + node.ends[group], node.end_count[group]};
  }
  /// The node above all others.
  [[nodiscard]] std::int32_t root() const { return static_cast<std::int32_t>(nodes_.size()) - 1; }
  /// The most nodes and leaves that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 96;

 private:
  class Builder;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<End> ends_;
};

}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::filtered::detail {

/// A hierarchy of boxes over the edges of loops in the plane, for distances and for inside or outside alike.
///
/// Every node represents a group of edges that lie near each other. The ends of a group are the vertices that belong to
/// only one of its edges. The horizontal line through a point outside a box meets the box on one side of the point
/// only. So the ray to the right crosses the edges in the box an odd number of times if and only if the box is met on
/// the right and the number of ends above the ray is odd. Only boxes near the point need closer examination. Boxes are
/// oriented along their edges, so that spikes have thin boxes. Four children per node and four edges per leaf, as
/// structure of arrays.
class EdgeTree {
 public:
  static constexpr std::size_t kWidth = 4;
  static constexpr std::size_t kMostEdges = std::size_t{1} << 26;

  struct Edge {
    double start_x, start_y, end_x, end_y;    ///< rounded
    double direction_x, direction_y, length;  ///< of the exact edge, each rounded once; the direction has length 1
  };

  /// Up to four edges. Lanes from `count` on hold an end of the last edge, as an edge of length 0.
  struct Leaf {
    /// Takes the edges with these numbers, one to four.
    Leaf(std::span<const Edge> edges, std::span<const std::uint32_t> numbers);

    alignas(32) double start_x[kWidth];
    double start_y[kWidth], end_x[kWidth], end_y[kWidth], direction_x[kWidth], direction_y[kWidth], length[kWidth];
    std::uint32_t edge[kWidth];
    std::uint32_t count;
  };

  /// Boxes and ends of up to four groups of edges. Unused groups have a box that is far from everything.
  struct Node {
    alignas(32) double center_x[kWidth];
    double center_y[kWidth], axis_x[kWidth], axis_y[kWidth];  ///< the axis has length 1, up to rounding
    double half_along[kWidth], half_across[kWidth];           ///< half sizes of the box plus bounds::kBoxRounding
    double lowest_end[kWidth], highest_end[kWidth];           ///< y of the ends; equal if no ends are stored
    std::uint32_t ends[kWidth], end_count[kWidth];            ///< the position and number of the stored ends
    std::int32_t child[kWidth];                               ///< a node, or ~leaf
    std::uint32_t with_more_ends;                             ///< one bit per group: it has more than two ends
  };

  struct End {
    double y;
    std::uint32_t vertex;
    friend auto operator<=>(const End&, const End&) = default;  // NOLINT(modernize-use-nullptr)
  };

  /// Builds the hierarchy. `loop_ends[l]` is one past the last edge of loop l. Requires at most kMostEdges edges. Cost:
  /// O(n log n). Memory: O(n log n) for loops that wind through every part of the plane, O(n) if neighbouring edges
  /// follow each other.
  EdgeTree(std::span<const Edge> edges, std::span<const std::size_t> loop_ends);

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }
  /// Returns the ends of a group of a node, ordered by y.
  [[nodiscard]] std::span<const End> ends_of(const Node& node, std::size_t group) const {
    return {ends_.data() + node.ends[group], node.end_count[group]};
  }
  /// Returns the index of the root node.
  [[nodiscard]] std::int32_t root() const { return static_cast<std::int32_t>(nodes_.size()) - 1; }
  /// The most nodes and leaves that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 96;

 private:
  class Builder;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<End> ends_;
};

/// The edges of a prepared polygon in its plane. A query looks at all of them, or walks a hierarchy of boxes, which is
/// built when the first query needs it. Several threads may query at once.
class EdgeIndex {
 public:
  using Edge = EdgeTree::Edge;
  using Leaf = EdgeTree::Leaf;

  /// How often the polygon will be queried. A single query never pays for a hierarchy. `OftenByHierarchy` walks one
  /// however few the edges are: tests compare both ways.
  enum class Use { Once, Often, OftenByHierarchy };
  /// Up to this many edges are looked at faster than a hierarchy is walked.
  static constexpr std::size_t kMostScanned = 32;

  /// Takes the edges of the polygon. Keeps a reference to it. Cost: linear.
  EdgeIndex(std::vector<Edge> edges, const Polygon& polygon, Use use);

  /// Returns whether queries look at all edges: those of leaves().
  [[nodiscard]] __attribute__((always_inline)) bool is_scanned() const { return !leaves_.empty(); }
  [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }

  /// Returns all edges, in groups: those that queries look at, or the leaves of the hierarchy.
  [[nodiscard]] const std::vector<Leaf>& all_leaves() const { return is_scanned() ? leaves_ : tree().leaves(); }

  /// Returns the hierarchy. Requires !is_scanned(). Cost: O(n log n) in the first call, then constant.
  [[nodiscard]] __attribute__((always_inline)) const EdgeTree& tree() const {
    const EdgeTree* const built = built_.load(std::memory_order_acquire);
    return built != nullptr ? *built : build();
  }

 private:
  const EdgeTree& build() const;

  std::vector<Leaf> leaves_;         // empty if queries walk the hierarchy
  mutable std::vector<Edge> edges_;  // until the hierarchy is built
  const Polygon& polygon_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const EdgeTree> tree_;
  mutable std::atomic<const EdgeTree*> built_{nullptr};
};

}  // namespace touchstone::filtered::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/edge_tree.h"

namespace touchstone::filtered {

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

}  // namespace touchstone::filtered

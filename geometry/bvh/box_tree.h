// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh/box.h"

namespace touchstone {

/// A hierarchy over boxes in space: which of them may a ball touch?
///
/// Four children a node, as structure of arrays, in floats that are rounded outwards. Before that all lengths are
/// multiplied by a power of two, so that neither the largest nor, but for boxes 2^-160 times as large, the smallest
/// ones leave the floats: no scene is too large or too small. A node's box holds the boxes of its children, after
/// rounding.
///
/// The tree is a function of the boxes alone, whatever rounding mode and flush-to-zero setting its caller has. Source:
/// [wald2007] (binned surface area heuristic).
///
/// Why not another's: see `touchstone bench --scene`. With a million triangles and small balls near them a scene of it
/// took 0.9 to 1.05 of the time of Embree 3, whose boxes are floats that exact answers cannot rest on, less than half
/// of that of Boost's R-tree, a twentieth of that of CGAL's AABB tree; with balls anywhere, where hardly more than
/// boxes is looked at, 1.3 times Embree's. It takes 90 bytes a triangle, with the triangle; they take 117, 65 and 136
/// beside it.
class BoxTree {
 public:
  static constexpr std::size_t kWidth = 4;                         ///< children of a node
  static constexpr std::uint32_t kMostInLeaf = 6;                  ///< boxes of a leaf, at most
  static constexpr std::size_t kMostBoxes = std::size_t{1} << 31;  ///< boxes of a tree, at most
  /// The most nodes that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 256;

  using Scale = std::array<double, 2>;  ///< two factors, whose product need be no double

  /// The children of a node, side by side.
  struct alignas(64) Node {
    /// @{
    /// The box of each child, by axis; that of one that is not there is empty.
    float low[3][kWidth], high[3][kWidth];
    /// @}
    std::uint32_t child[kWidth];  ///< a node, or where a leaf begins in `order`; 0 for none
    std::uint32_t count[kWidth];  ///< how many boxes a leaf has; 0 for a node
  };

  /// Requires boxes that are finite and not empty, at most kMostBoxes. Cost: O(n log n), about 1 us a box on one core;
  /// all cores of the machine work on many boxes.
  explicit BoxTree(std::span<const Box> boxes);

  /// The first node is above all others; none for no boxes.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// The numbers of the boxes, leaf by leaf.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// Lengths in the tree are true ones times scale[0] times scale[1], which are powers of two.
  [[nodiscard]] const Scale& scale() const { return scale_; }

  /// Takes other boxes in place of the old ones, number by number, and keeps the tree's shape. Requires what the
  /// constructor does. Cost: linear.
  void refit(std::span<const Box> boxes);
  /// The surfaces of all nodes' boxes in sum, over what that was when the tree was built: how much more a walk meets
  /// than it did then.
  [[nodiscard]] double growth() const;

 private:
  [[nodiscard]] double surface() const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  Scale scale_ = {1, 1};
  double built_surface_;
  Scale built_scale_;
};

}  // namespace touchstone

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh/box.h"

namespace touchstone {

/// A bounding volume hierarchy over boxes in space, to find those that a ball may touch.
///
/// Four children per node, as structure of arrays, in floats rounded outwards. Lengths are first multiplied by a power
/// of two. So the largest stay within the floats, and so do the smallest, except for boxes 2^-160 times as large: no
/// scene is too large or too small. The box of a node contains the boxes of its children, after rounding.
///
/// The tree depends only on the boxes, not on the caller's rounding mode and flush-to-zero setting. Source: [wald2007]
/// (binned surface area heuristic).
///
/// Why not a library: `touchstone bench-scenes` compares. For a million triangles and small balls near them a scene on
/// this tree took 0.6 to 1 of the processor time of Embree 3, whose boxes are floats that cannot support exact answers;
/// less than half of the time of Boost's R-tree; a twentieth of that of CGAL's AABB tree. For random balls it took half
/// of Embree's time to find the nearest triangle, and 1 to 1.4 times to test little more than boxes. Per triangle this
/// tree takes 13 bytes; the libraries take 117, 65 and 136.
class BoxTree {
 public:
  static constexpr std::size_t kWidth = 4;                         ///< the number of children of a node
  static constexpr std::uint32_t kMostInLeaf = 8;                  ///< the most boxes of a leaf
  static constexpr std::size_t kMostBoxes = std::size_t{1} << 31;  ///< the most boxes of a tree
  /// The most nodes that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 256;

  using Scale = std::array<double, 2>;  ///< two factors, whose product need not be a double

  /// The children of a node.
  struct alignas(64) Node {
    /// @{
    /// The box of each child, by axis. Missing children have empty boxes.
    float low[3][kWidth], high[3][kWidth];
    /// @}
    std::uint32_t child[kWidth];  ///< the index of a node, or of the first place of a leaf in `order`; 0 if missing
    std::uint8_t count[kWidth];   ///< the number of boxes of a leaf; 0 for a node
    std::uint32_t leaves;         ///< one bit for each child that is a leaf
    std::uint32_t first_leaf;     ///< the number of the first of these leaves; the others follow

    /// Returns the number of the leaf in a lane. Leaves are numbered from 0 in the order of nodes, then of lanes.
    [[nodiscard]] __attribute__((always_inline)) std::uint32_t leaf(unsigned lane) const {
      constexpr unsigned bits_of_three_lanes = 0x32212110;  // digit i is the number of bits of i
      return first_leaf + (bits_of_three_lanes >> 4 * (leaves & ((1U << lane) - 1)) & 0xf);
    }
  };

  /// Builds the tree. Requires boxes that are finite and not empty, at most kMostBoxes. Cost: O(n log n), about 1 us
  /// per box on one core; uses all cores of the machine if there are many boxes.
  explicit BoxTree(std::span<const Box> boxes);

  /// Returns the nodes. The first is the root. Without boxes there are no nodes.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Returns the number of leaves.
  [[nodiscard]] std::uint32_t leaf_count() const { return leaf_count_; }
  /// Returns the numbers of the boxes, leaf by leaf.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// Returns the scale: lengths in the tree are true lengths times scale[0] times scale[1], which are powers of two.
  [[nodiscard]] const Scale& scale() const { return scale_; }

  /// Replaces the boxes, number by number, and keeps the shape of the tree. Requires as many boxes as before, with the
  /// properties that the constructor requires. Cost: linear.
  void refit(std::span<const Box> boxes);
  /// Returns the total surface of all nodes' boxes, relative to what it was when the tree was built: how much more a
  /// walk visits than it did then.
  [[nodiscard]] double growth() const;

 private:
  [[nodiscard]] double surface() const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::uint32_t leaf_count_ = 0;
  Scale scale_ = {1, 1};
  double built_surface_;
  Scale built_scale_;
};

}  // namespace touchstone

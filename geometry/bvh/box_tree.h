// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/bvh/box.h"

namespace touchstone {

/// A bounding volume hierarchy over boxes in space, to find those that a ball may touch.
///
/// Eight children per node, as structure of arrays, in floats rounded outwards to multiples of a power of two, the
/// node's step: 16 bits per side suffice. Lengths are first multiplied by a power of two. So the largest stay within
/// the floats, and so do the smallest, except for boxes 2^-160 times as large: no scene is too large or too small.
///
/// The tree depends only on the boxes, not on the caller's rounding mode and flush-to-zero setting. Source: [wald2007]
/// (binned surface area heuristic), [ylitie2017] (quantised boxes, and nodes that cost a walk least).
///
/// Why not a library: `touchstone bench-scenes` compares. For a million triangles and small balls near them a scene on
/// this tree took 0.4 to 0.9 of the time of Embree 3, whose boxes are floats that cannot support exact answers; a tenth
/// of that of CGAL's AABB tree, for the nearest triangle a third. For random balls it took less than half of Embree's
/// time to find the nearest triangle, and 0.9 to 1.1 times to test little more than boxes. Per triangle this tree takes
/// 8 bytes; the libraries take 111 and 135.
class BoxTree {
 public:
  static constexpr std::size_t kWidth = 8;                         ///< the most children of a node
  static constexpr std::uint32_t kMostInLeaf = 8;                  ///< the most boxes of a leaf
  static constexpr std::size_t kMostBoxes = std::size_t{1} << 28;  ///< the most boxes of a tree
  static constexpr std::uint32_t kNone = 0xffff'ffff;              ///< no number of a box
  /// The most nodes that are open at once in a depth-first walk.
  static constexpr std::size_t kStackSize = 512;

  using Scale = std::array<double, 2>;  ///< two factors, whose product need not be a double

  /// The children of a node: first leaves, then nodes.
  struct alignas(64) Node {
    /// @{
    /// The box of each child, by axis, in steps from the origin.
    std::uint16_t low[3][kWidth], high[3][kWidth];
    /// @}
    float origin[3];             ///< a multiple of the step, by less than 2^24
    std::uint32_t first_node;    ///< the index of the first child that is a node; the others follow
    std::uint32_t first_leaf;    ///< the number of the first child that is a leaf; the others follow
    std::uint8_t exponent;       ///< of the step as a float: biased
    std::uint8_t leaf_count;     ///< the number of children that are leaves
    std::uint8_t child_count;    ///< the number of all children
    std::uint8_t count[kWidth];  ///< the number of boxes of each child that is a leaf

    /// Returns the step. A side of a box lies at its origin plus its steps, which is a float.
    [[nodiscard]] __attribute__((always_inline)) float step() const {
      constexpr int fraction_bits = std::numeric_limits<float>::digits - 1;
      return std::bit_cast<float>(std::uint32_t{exponent} << fraction_bits);
    }
  };

  /// Builds the tree. Requires boxes that are finite and not empty, at most kMostBoxes. Cost: O(n log n), about 1 us
  /// per box on one core; uses all cores of the machine if there are many boxes.
  explicit BoxTree(std::span<const Box> boxes);

  /// Returns the nodes. The first is the root. Without boxes there are no nodes.
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  /// Returns the number of leaves.
  [[nodiscard]] std::uint32_t leaf_count() const { return leaf_count_; }
  /// Returns the number of boxes.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Returns the numbers of the boxes by place: leaf i has the places from kMostInLeaf i on. Places of leaves that are
  /// not full have kNone.
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
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::size_t size_;
  std::uint32_t leaf_count_ = 0;
  Scale scale_;
  double surface_;  ///< half the sum of the surfaces of all nodes' boxes
  Scale built_scale_;
  double built_surface_;
};

}  // namespace touchstone

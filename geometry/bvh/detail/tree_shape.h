// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "geometry/bvh/box_tree.h"

namespace touchstone::bvh {

// The boxes of a tree while it is built, in floats.

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Three coordinates, and a number that does not matter.
using Corner = float __attribute__((vector_size(16)));

constexpr Corner all(float x) { return Corner{x, x, x, x}; }
/// Returns a where b is not a number.
inline Corner least(Corner a, Corner b) { return b < a ? b : a; }
inline Corner most(Corner a, Corner b) { return a < b ? b : a; }

/// A box in floats.
struct Bounds {
  Corner low = all(kInfinity), high = all(-kInfinity);

  void join(const Bounds& other) {
    low = least(low, other.low);
    high = most(high, other.high);
  }
  /// Returns half the surface; 0 for an empty box.
  [[nodiscard]] float surface() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

/// A box, before it is in a leaf: its corners, of which the low one also holds its number.
class Item {
 public:
  Item() = default;
  Item(const Bounds& bounds, std::uint32_t number)
      : low_(bounds.low), high_{bounds.high[0], bounds.high[1], bounds.high[2]} {
    std::memcpy(reinterpret_cast<char*>(&low_) + kNumberAt, &number, sizeof(number));
  }

  [[nodiscard]] std::uint32_t number() const {
    std::uint32_t number = 0;
    std::memcpy(&number, reinterpret_cast<const char*>(&low_) + kNumberAt, sizeof(number));
    return number;
  }
  [[nodiscard]] Bounds bounds() const { return {low_, high_}; }
  /// Returns twice the centre.
  [[nodiscard]] Corner center() const { return Corner{low_[0], low_[1], low_[2]} + high_; }

 private:
  static constexpr std::size_t kNumberAt = 3 * sizeof(float);

  Corner low_, high_;
};

/// Consecutive items.
struct Range {
  std::uint32_t begin, end;
  Bounds bounds;

  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

/// The nodes of a tree, of which the first is the root, without their boxes, and its leaves by number.
struct TreeShape {
  std::vector<BoxTree::Node> nodes = std::vector<BoxTree::Node>(1);
  std::vector<Range> leaves;
};

/// Sorts the items into leaves, and returns these and the nodes above them; neither if there are no items. Requires
/// round to nearest, without flush-to-zero. Uses all cores.
///
/// A binary tree comes first, by the binned surface area heuristic [wald2007]. It is then collapsed to the wide nodes
/// that a walk is expected to pay least for [ylitie2017].
[[nodiscard]] TreeShape shape_of(std::vector<Item>& items);

}  // namespace touchstone::bvh

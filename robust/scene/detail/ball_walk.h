// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/bvh/box_tree.h"
#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/numbers/pack.h"

/// Finds the boxes of a tree that a ball may touch.
namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

using filtered::Pack;

/// The operations of culling, over any number type. The tests run the error calculus of robust/proofs over them.
namespace culling {

/// Added to a ball's radius to cover underflow in centres, radii and boxes, which is at most 2^-1074 in each.
inline constexpr double kTiny = 0x1p-500;
/// Multiplied with the square of a ball's reach to cover its rounding and that of the squares that are compared with
/// it. Proved in tests/robust/proofs/culling_test.cpp.
inline constexpr double kWide = 1 + 0x1p-47;

/// Returns how far a coordinate of a centre is outside an interval; 0 within it.
template <class T>
TOUCHSTONE_INLINE T gap(const T& low, const T& high, const T& center, const T& zero) {
  return maximum(maximum(low - center, center - high), zero);
}

/// Returns the square of the distance to a box with these gaps.
template <class T>
TOUCHSTONE_INLINE T squared_distance(const T& x, const T& y, const T& z) {
  return multiply_add(x, x, multiply_add(y, y, z * z));
}

/// Returns the limit for the squares of the distances to boxes.
template <class T>
TOUCHSTONE_INLINE T squared_reach(const T& reach, const T& wide) {
  return reach * reach * wide;
}

}  // namespace culling

/// A ball in the units of a tree, to test it against boxes.
///
/// Culling is conservative: a box that the ball touches is never culled. Squares do not overflow, because all numbers
/// are below 2^500. If a ball cannot be scaled so, no box is culled.
class CullingBall {
 public:
  /// Requires round to nearest, without flush-to-zero.
  CullingBall(const Ball& ball, const BoxTree& tree) {
    const auto scaled = [&tree](double length) { return length * tree.scale()[0] * tree.scale()[1]; };
    for (int axis = 0; axis < 3; ++axis) center_[axis] = scaled(ball.center[axis]);
    const double largest = std::max({std::abs(center_[0]), std::abs(center_[1]), std::abs(center_[2])});
    everywhere_ = !(largest < 0x1p500);
    if (everywhere_) center_[0] = center_[1] = center_[2] = 0;
    set_radius(ball.radius, tree);
  }

  /// Sets the radius, to shrink the ball.
  void set_radius(double radius, const BoxTree& tree) {
    const double reach = radius * tree.scale()[0] * tree.scale()[1] + culling::kTiny;
    squared_ = everywhere_ || !(reach < 0x1p500) ? 0x1p1020 : culling::squared_reach(reach, culling::kWide);
  }

  /// Returns the squares of the distances to the boxes of a node; infinite for missing children.
  [[nodiscard]] Pack squares(const BoxTree::Node& node) const {
    const Pack zero = filtered::all_lanes(0);
    const auto gap = [&](int axis) {
      return culling::gap(filtered::load(node.low[axis]), filtered::load(node.high[axis]),
                          filtered::all_lanes(center_[axis]), zero);
    };
    return culling::squared_distance(gap(0), gap(1), gap(2));
  }
  /// Returns one bit for each box that the ball may touch.
  [[nodiscard]] unsigned may_touch(const Pack& squares) const {
    return ~negative_lanes(filtered::all_lanes(squared_) - squares) & 0b1111;
  }

  /// Returns whether the ball may touch a box with this squared distance.
  [[nodiscard]] bool may_touch(double square) const { return square <= squared_; }

 private:
  double center_[3];
  double squared_;
  bool everywhere_;
};

/// Fetches the bytes of objects from memory, for when the walk comes to them.
template <class Object>
TOUCHSTONE_INLINE void prefetch(const Object* objects, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto* bytes = reinterpret_cast<const char*>(objects);
  for (std::size_t at = 0; at < count * sizeof(Object); at += line) __builtin_prefetch(bytes + at);
}

/// Calls visit(place) for each place in tree.order() whose leaf the ball may touch. Stops if it returns true, and
/// returns whether it did. With `nearest_first` the nearest of the boxes found so far is entered first, and visit may
/// shrink `culling_ball`. Calls prefetch_leaf(first, count) some time before it visits these places.
template <bool nearest_first, class Visit, class PrefetchLeaf>
bool walk(const BoxTree& tree, const CullingBall& culling_ball, const Visit& visit, const PrefetchLeaf& prefetch_leaf) {
  if (tree.nodes().empty()) return false;
  /// A node, or `count` places from `first`.
  struct Open {
    std::uint32_t first, count;
    double squared;  ///< only for `nearest_first`
  };
  Open stack[BoxTree::kStackSize];
  std::size_t open = 0;
  stack[open++] = {0, 0, 0};
  while (open > 0) {
    const Open top = stack[--open];
    if constexpr (nearest_first)
      if (!culling_ball.may_touch(top.squared)) continue;
    if (top.count != 0) {
      for (std::uint32_t place = top.first; place < top.first + top.count; ++place)
        if (visit(place)) return true;
      continue;
    }
    const BoxTree::Node& node = tree.nodes()[top.first];
    const Pack squares = culling_ball.squares(node);
    double distances[filtered::kLanes];
    if constexpr (nearest_first) store(distances, squares);
    const std::size_t bottom = open;
    for (unsigned candidates = culling_ball.may_touch(squares); candidates != 0; candidates &= candidates - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(candidates));
      const Open next{node.child[lane], node.count[lane], nearest_first ? distances[lane] : 0};
      if (next.count == 0)
        prefetch(&tree.nodes()[next.first], 1);
      else
        prefetch_leaf(next.first, next.count);
      std::size_t at = open++;
      if constexpr (nearest_first)
        for (; at > bottom && stack[at - 1].squared < next.squared; --at) stack[at] = stack[at - 1];
      stack[at] = next;
    }
  }
  return false;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene

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

/// Returns how far an interval is from another, that of a centre's coordinate from `first` to `last`; 0 if they meet.
template <class T>
TOUCHSTONE_INLINE T gap(const T& low, const T& high, const T& first, const T& last, const T& zero) {
  return maximum(maximum(low - last, first - high), zero);
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

/// Returns a length in the units of a tree.
TOUCHSTONE_INLINE double scaled(double length, const BoxTree& tree) {
  return length * tree.scale()[0] * tree.scale()[1];
}

/// A ball in the units of a tree, to test it against boxes.
///
/// Culling is conservative: a box that the ball touches is never culled. Squares do not overflow, because all numbers
/// are below 2^500. If a ball cannot be scaled so, no box is culled.
class CullingBall {
 public:
  /// Requires round to nearest, without flush-to-zero.
  CullingBall(const Ball& ball, const BoxTree& tree) {
    for (int axis = 0; axis < 3; ++axis) center_[axis] = scaled(ball.center[axis], tree);
    const double largest = std::max({std::abs(center_[0]), std::abs(center_[1]), std::abs(center_[2])});
    everywhere_ = !(largest < 0x1p500);
    if (everywhere_) center_[0] = center_[1] = center_[2] = 0;
    set_radius(ball.radius, tree);
  }

  /// Sets the radius, to shrink the ball.
  void set_radius(double radius, const BoxTree& tree) {
    const double reach = scaled(radius, tree) + culling::kTiny;
    squared_ = everywhere_ || !(reach < 0x1p500) ? 0x1p1020 : culling::squared_reach(reach, culling::kWide);
  }

  /// Returns one bit for each box of a node that the ball may touch. Writes the squares of their distances.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node, Pack& squares) const {
    const Pack zero = filtered::all_lanes(0);
    const auto gap = [&](int axis) {
      const Pack center = filtered::all_lanes(center_[axis]);
      return culling::gap(filtered::load(node.low[axis]), filtered::load(node.high[axis]), center, center, zero);
    };
    squares = culling::squared_distance(gap(0), gap(1), gap(2));  // infinite for missing children
    return ~negative_lanes(filtered::all_lanes(squared_) - squares) & 0b1111;
  }

  /// Returns whether the ball may touch a box with this squared distance.
  [[nodiscard]] bool may_touch(double square) const { return square <= squared_; }

 private:
  double center_[3];
  double squared_;
  bool everywhere_;
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene

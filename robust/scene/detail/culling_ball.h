// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bvh/box_tree.h"
#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/numbers/lanes.h"

/// Finds the boxes of a tree that a ball may touch.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

using filtered::detail::FloatPack;
using filtered::detail::Pack;

/// The operations of culling, over any number type. The tests run the error calculus of robust/proofs over them.
namespace culling {

using filtered::detail::maximum, filtered::detail::multiply_add;

/// Added to a ball's radius to cover underflow in centres, radii and boxes, which is at most 2^-1074 in each.
inline constexpr double kTiny = 0x1p-500;
/// Multiplied with the square of a ball's reach to cover its rounding and that of the squares that are compared with
/// it, in doubles and in floats. Proved in tests/robust/proofs/culling_test.cpp, as are the next three constants.
inline constexpr double kWide = 1 + 0x1p-47, kWideFloat = 1 + 0x1p-20;
/// Added to the square of a ball's reach to cover underflow of squares in floats. Subnormal numbers would be slow.
inline constexpr double kTinyFloat = 0x1p-120;
/// A coordinate is this share of the nearest float away from it at most, or the least normal number.
inline constexpr double kApartFloat = 0x1p-22;
/// Balls whose numbers are larger are tested in doubles. Boxes reach 2^40 at most.
inline constexpr double kLargestFloat = 0x1p50;

/// Returns how far from a number its nearest float may be at most, and as much again for the ends of the interval that
/// is made of it.
inline float apart(float nearest) {
  return std::abs(nearest) * static_cast<float>(kApartFloat) + std::numeric_limits<float>::min();
}

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

/// Returns the reach of a ball in the units of a tree.
TOUCHSTONE_INLINE double reach_of(double radius, const BoxTree& tree) { return scaled(radius, tree) + culling::kTiny; }

/// Returns one bit for each child of a node.
TOUCHSTONE_INLINE unsigned all_children(const BoxTree::Node& node) { return (1U << node.child_count) - 1; }

/// Returns four of eight floats as doubles.
TOUCHSTONE_INLINE Pack half(const FloatPack& eight, int first) {
  float floats[filtered::detail::kFloatLanes];
  store(floats, eight);
  return filtered::detail::load(floats + first);
}

/// The boxes of a node's children along one axis.
struct Sides {
  FloatPack low, high;
};
TOUCHSTONE_INLINE Sides sides(const BoxTree::Node& node, int axis) {
  const FloatPack step = filtered::detail::all_float_lanes(node.step());
  const FloatPack origin = filtered::detail::all_float_lanes(node.origin[axis]);
  return {multiply_add(filtered::detail::load(node.low[axis]), step, origin),
          multiply_add(filtered::detail::load(node.high[axis]), step, origin)};  // exact
}

/// A ball in the units of a tree, in floats.
struct FloatReach {
  float first[3], last[3];  ///< between which the centre is
  float limit;              ///< for the squares of the distances of boxes that the ball may touch

  /// Sets a ball. Returns false if it is beyond floats. Requires round to nearest, without flush-to-zero.
  TOUCHSTONE_INLINE bool set(const Ball& ball, const BoxTree& tree) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double coordinate = scaled(ball.center[axis], tree);
      largest = std::max(largest, std::abs(coordinate));
      set_center(axis, coordinate);
    }
    const double reach = reach_of(ball.radius, tree);
    set_reach(reach);
    return largest <= culling::kLargestFloat && reach <= culling::kLargestFloat;
  }
  /// Sets the radius, which may be beyond floats: the ball then touches all boxes.
  TOUCHSTONE_INLINE void set_radius(double radius, const BoxTree& tree) {
    const double reach = reach_of(radius, tree);
    set_reach(reach);
    if (!(reach <= culling::kLargestFloat)) limit = std::numeric_limits<float>::infinity();
  }

  /// Requires a coordinate of the centre that is at most kLargestFloat in magnitude.
  TOUCHSTONE_INLINE void set_center(int axis, double coordinate) {
    const auto nearest = static_cast<float>(coordinate);
    const float apart = culling::apart(nearest);
    first[axis] = nearest - apart, last[axis] = nearest + apart;
  }
  /// Requires a reach that is at most kLargestFloat.
  TOUCHSTONE_INLINE void set_reach(double reach) {
    limit = static_cast<float>(culling::squared_reach(reach, culling::kWideFloat) + culling::kTinyFloat);
  }
};

/// The boxes of a node's children.
class NodeBoxes {
 public:
  explicit TOUCHSTONE_INLINE NodeBoxes(const BoxTree::Node& node)
      : sides_{sides(node, 0), sides(node, 1), sides(node, 2)}, all_(all_children(node)), count_(node.child_count) {}

  /// Returns the squares of their distances.
  [[nodiscard]] TOUCHSTONE_INLINE FloatPack squares(const FloatReach& ball) const {
    const FloatPack zero = filtered::detail::all_float_lanes(0);
    const auto gap = [&](int axis) {
      return culling::gap(sides_[axis].low, sides_[axis].high, filtered::detail::all_float_lanes(ball.first[axis]),
                          filtered::detail::all_float_lanes(ball.last[axis]), zero);
    };
    return culling::squared_distance(gap(0), gap(1), gap(2));
  }
  /// Returns one bit for each box at the distances of these squares that the ball may touch.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned met_by(const FloatReach& ball, const FloatPack& squares) const {
    return ~negative_lanes(filtered::detail::all_float_lanes(ball.limit) - squares) & all_;
  }
  [[nodiscard]] TOUCHSTONE_INLINE unsigned met_by(const FloatReach& ball) const { return met_by(ball, squares(ball)); }
  /// Returns one bit for the box whose distance is least, or none if the ball does not touch it.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned nearest_met_by(const FloatReach& ball) const {
    const FloatPack here = squares(ball);
    const FloatPack least = filtered::detail::all_float_lanes(least_of_first(here, count_));
    const unsigned nearest = ~negative_lanes(least - here) & met_by(ball, here);
    return nearest & -nearest;
  }

 private:
  Sides sides_[3];
  unsigned all_, count_;
};

/// A ball in the units of a tree, to test it against boxes.
///
/// Culling is conservative: a box that the ball touches is never culled. Squares do not overflow, because all numbers
/// are below 2^50 in floats, else below 2^500. If a ball cannot be scaled so, no box is culled.
class CullingBall {
 public:
  /// Requires round to nearest, without flush-to-zero.
  CullingBall(const Ball& ball, const BoxTree& tree) {
    for (int axis = 0; axis < 3; ++axis) center_[axis] = scaled(ball.center[axis], tree);
    largest_ = std::max({std::abs(center_[0]), std::abs(center_[1]), std::abs(center_[2])});
    everywhere_ = !(largest_ < 0x1p500);
    if (everywhere_) center_[0] = center_[1] = center_[2] = 0;
    if (largest_ <= culling::kLargestFloat)
      for (int axis = 0; axis < 3; ++axis) floats_.set_center(axis, center_[axis]);
    set_radius(ball.radius, tree);
  }

  /// Sets the radius, to shrink the ball.
  void set_radius(double radius, const BoxTree& tree) {
    const double reach = reach_of(radius, tree);
    in_floats_ = largest_ <= culling::kLargestFloat && reach <= culling::kLargestFloat;
    if (in_floats_) {
      floats_.set_reach(reach);
      squared_ = static_cast<double>(floats_.limit);
    } else {
      squared_ = everywhere_ || !(reach < 0x1p500) ? 0x1p1020 : culling::squared_reach(reach, culling::kWide);
    }
  }

  /// Returns one bit for each child of a node whose box the ball may touch.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node) const {
    if (in_floats_) [[likely]]
      return NodeBoxes(node).met_by(floats_);
    double squares[BoxTree::kWidth];
    return may_touch_in_doubles(node, squares);
  }
  /// The same, and writes the keys of these boxes.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node,
                                                     double (&squares)[BoxTree::kWidth]) const {
    if (!in_floats_) [[unlikely]]
      return may_touch_in_doubles(node, squares);
    const NodeBoxes boxes(node);
    const FloatPack here = boxes.squares(floats_);
    float floats[BoxTree::kWidth];
    store(floats, here);
    for (std::size_t first = 0; first < BoxTree::kWidth; first += filtered::detail::kLanes)
      store(squares + first, filtered::detail::load(floats + first));
    return boxes.met_by(floats_, here);
  }

  /// Returns whether the ball may touch a box with this key, the square of its distance.
  [[nodiscard]] bool may_touch(double square) const { return square <= squared_; }

 private:
  [[nodiscard]] __attribute__((noinline)) unsigned may_touch_in_doubles(const BoxTree::Node& node,
                                                                        double (&squares)[BoxTree::kWidth]) const {
    const Pack zero = filtered::detail::all_lanes(0), limit = filtered::detail::all_lanes(squared_);
    unsigned touched = 0;
    for (int first = 0; first < static_cast<int>(BoxTree::kWidth); first += filtered::detail::kLanes) {
      const auto gap = [&](int axis) {
        const Sides box = sides(node, axis);
        const Pack center = filtered::detail::all_lanes(center_[axis]);
        return culling::gap(half(box.low, first), half(box.high, first), center, center, zero);
      };
      const Pack here = culling::squared_distance(gap(0), gap(1), gap(2));
      store(squares + first, here);
      touched |= (~negative_lanes(limit - here) & 0b1111) << first;
    }
    return touched & all_children(node);
  }

  double center_[3], largest_, squared_;
  FloatReach floats_;  ///< if in_floats_
  bool everywhere_, in_floats_;
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

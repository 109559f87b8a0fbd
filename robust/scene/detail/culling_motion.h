// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bvh/box_tree.h"
#include "geometry/shapes/motion.h"
#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/scene/detail/culling_ball.h"
#include "robust/scene/detail/shared_vertices.h"

/// Finds the boxes of a tree that a moving ball may touch, and the triangles whose boxes it misses.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// Returns a moving centre, or one of its coordinates, after some time; over any number type, as in culling_ball.h.
template <class T, class Time>
TOUCHSTONE_INLINE T place_at(const T& first, const Time& time, const T& change) {
  return first + time * change;
}

namespace culling {

/// Lengths of a motion, in units of the largest number of centres and reach: by kMargin more does the ball reach along
/// each axis, to cover the rounding of times and ends. A centre that moves by less than kStill along an axis has no
/// times for it, so that times are finite. Proved in tests/robust/proofs/culling_motion_test.cpp.
inline constexpr double kMargin = 21 * 0x1p-53, kStill = 0x1p-30;

/// Returns a centre's coordinate plus the ball's side, in units of the centre's change along the axis.
template <class T>
TOUCHSTONE_INLINE T offset(const T& center, const T& side, const T& inverse) {
  return (center + side) * inverse;
}

/// Returns the time at which a side of the ball is at a side of a box: the centre's coordinate moves with speed
/// 1 / inverse, and at time 0 the ball's side is at -offset / inverse.
template <class T>
TOUCHSTONE_INLINE T time_at(const T& side, const T& inverse, const T& offset) {
  return multiply_add(side, inverse, offset);
}

}  // namespace culling

/// A moving ball in the units of a tree, to test it against boxes.
///
/// Culling is conservative: a box that the ball touches until the time of `end_at` is never culled, and the time that
/// is computed for a box is not later than the one at which the ball touches it first. Two tests cull: the box's
/// distance from the box around the centre's way, and the times at which the ball's own box meets it along each axis.
/// The second test is left out for motions of at most two radii, where it culls little: all times are 0 then. If a
/// motion cannot be scaled, no box is culled.
class CullingMotion {
 public:
  /// @{
  /// Requires round to nearest, without flush-to-zero.
  TOUCHSTONE_INLINE CullingMotion(const Motion& motion, const BoxTree& tree)
      : CullingMotion(Motion({{scaled(motion.ball.center[0], tree), scaled(motion.ball.center[1], tree),
                               scaled(motion.ball.center[2], tree)},
                              scaled(motion.ball.radius, tree)},
                             {scaled(motion.to[0], tree), scaled(motion.to[1], tree), scaled(motion.to[2], tree)})) {}
  /// For boxes that are not scaled.
  TOUCHSTONE_INLINE explicit CullingMotion(const Motion& motion) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      center_[axis] = motion.ball.center[axis], to_[axis] = motion.to[axis];
      largest = std::max({largest, std::abs(center_[axis]), std::abs(to_[axis])});
    }
    const double reach = motion.ball.radius + culling::kTiny;
    everywhere_ = !(largest < 0x1p500 && reach < 0x1p500);
    if (everywhere_) largest = 0;
    squared_ = everywhere_ ? 0x1p1020 : culling::squared_reach(reach, culling::kWide);
    largest = std::max(largest, reach);
    margin_ = everywhere_ ? 0 : culling::kMargin * largest;
    double longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (everywhere_) center_[axis] = to_[axis] = 0;
      const double change = to_[axis] - center_[axis];
      longest = std::max(longest, std::abs(change));
      if (!everywhere_ && std::abs(change) > culling::kStill * largest) {
        const double inverse = 1 / change, side = std::copysign(reach + margin_, change);
        inverse_[axis] = inverse;
        entry_[axis] = -culling::offset(center_[axis], side, inverse);
        exit_[axis] = -culling::offset(center_[axis], -side, inverse);
      } else {
        // No side of a box that the ball may touch, times the inverse, is more than 2^-90.
        inverse_[axis] = 0x1p-600, entry_[axis] = -1, exit_[axis] = 2;
      }
      forward_[axis] = !(inverse_[axis] < 0);
    }
    timed_ = longest > 2 * reach;
    end_at(1);
  }
  /// @}

  /// Shortens the motion: it ends at this time.
  TOUCHSTONE_INLINE void end_at(double time) {
    end_ = time;
    for (int axis = 0; axis < 3; ++axis) {
      const double first = center_[axis], change = to_[axis] - first;
      const double last = time < 1 ? place_at(first, time, change) + std::copysign(margin_, change) : to_[axis];
      low_[axis] = std::min(first, last), high_[axis] = std::max(first, last);
    }
  }

  /// Returns one bit for each child of a node whose box the ball may touch.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node) const {
    double times[BoxTree::kWidth];
    return may_touch(node, times);
  }
  /// The same, and writes the keys of these boxes.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node,
                                                     double (&times)[BoxTree::kWidth]) const {
    unsigned touched = half_touched(node, 0, times);
    if (node.child_count > filtered::detail::kLanes)
      touched |= half_touched(node, filtered::detail::kLanes, times) << filtered::detail::kLanes;
    return touched & all_children(node);
  }
  /// The same for two boxes that are not scaled.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const Box (&boxes)[2],
                                                     double (&times)[filtered::detail::kLanes]) const {
    if (everywhere_) {
      times[0] = times[1] = 0;
      return 0b11;
    }
    Pack low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = filtered::detail::pack(boxes[0].low[axis], boxes[1].low[axis], 0, 0);
      high[axis] = filtered::detail::pack(boxes[0].high[axis], boxes[1].high[axis], 0, 0);
    }
    return touched(low, high, times) & 0b11;
  }
  /// Returns whether the ball may touch a box with this key, the earliest time at which it may.
  [[nodiscard]] bool may_touch(double time) const { return time <= end_; }

 private:
  /// Returns which of the boxes from `first` on the ball may touch, and writes the earliest times at which it may.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned half_touched(const BoxTree::Node& node, int first, double* times) const {
    Pack low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      const Sides box = sides(node, axis);
      low[axis] = half(box.low, first), high[axis] = half(box.high, first);
    }
    return touched(low, high, times + first);
  }
  /// The same for the boxes with these sides.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned touched(const Pack (&low)[3], const Pack (&high)[3], double* times) const {
    const Pack zero = filtered::detail::all_lanes(0);
    const auto gap = [&](int axis) {
      return culling::gap(low[axis], high[axis], filtered::detail::all_lanes(low_[axis]),
                          filtered::detail::all_lanes(high_[axis]), zero);
    };
    const Pack apart = filtered::detail::all_lanes(squared_) - culling::squared_distance(gap(0), gap(1), gap(2));
    Pack entry = zero, exit = filtered::detail::all_lanes(end_);
    if (timed_)
      for (int axis = 0; axis < 3; ++axis) {
        const Pack inverse = filtered::detail::all_lanes(inverse_[axis]);
        entry = maximum(entry, culling::time_at(forward_[axis] ? low[axis] : high[axis], inverse,
                                                filtered::detail::all_lanes(entry_[axis])));
        exit = minimum(exit, culling::time_at(forward_[axis] ? high[axis] : low[axis], inverse,
                                              filtered::detail::all_lanes(exit_[axis])));
      }
    store(times, entry);
    return ~negative_lanes(timed_ ? apart | (exit - entry) : apart) & ((1U << filtered::detail::kLanes) - 1);
  }

  double center_[3], to_[3];
  double low_[3], high_[3];  ///< the box around the centre's way until then
  double inverse_[3], entry_[3], exit_[3];
  bool forward_[3], timed_, everywhere_;
  double squared_, margin_, end_;
};

namespace swept {

/// By how much the radius of a shortened motion is larger: kMargin times the largest coordinate or radius, to cover the
/// roundings of the end and of the radius itself, and kTiny to cover underflow. Proved in
/// tests/robust/proofs/culling_motion_test.cpp.
inline constexpr double kMargin = 15 * 0x1p-53, kTiny = 0x1p-1071;

/// Returns the radius of a shortened motion, given the largest coordinate or radius.
template <class T>
TOUCHSTONE_INLINE T wider(const T& radius, const T& margin, const T& largest, const T& tiny) {
  return radius + margin * largest + tiny;
}

}  // namespace swept

/// The space that a moving ball sweeps until some time: its motion, and the box around it. Only ever too large.
/// Requires round to nearest, without flush-to-zero.
class Swept {
 public:
  TOUCHSTONE_INLINE explicit Swept(const Motion& motion) : whole_(motion), motion_(motion) { set_box(); }

  /// Shortens the motion: it ends at this time. The end of the way is rounded; a larger radius makes up for that.
  TOUCHSTONE_INLINE void end_at(double time) {
    const Eigen::Vector3d &first = whole_.ball.center, &last = whole_.to, change = last - first;
    if (!(change.lpNorm<Eigen::Infinity>() <= std::numeric_limits<double>::max())) return;
    const double largest = std::max(first.lpNorm<Eigen::Infinity>(), last.lpNorm<Eigen::Infinity>());
    motion_.to = place_at(first, time, change);
    motion_.ball.radius =
        swept::wider(whole_.ball.radius, swept::kMargin, std::max(largest, whole_.ball.radius), swept::kTiny);
    set_box();
  }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  /// Returns whether the ball certainly misses the triangle's box along some axis. Culls most triangles of a leaf.
  [[nodiscard]] TOUCHSTONE_INLINE bool misses(const SharedTriangle& triangle) const {
    using filtered::detail::Pack;
    const Pack low = filtered::detail::load_three(low_), high = filtered::detail::load_three(high_);
    // A radius of -0 becomes +0: -0 - 0 and -0 + -0 have the sign of a miss.
    const Pack radius = filtered::detail::all_lanes(motion_.ball.radius + 0.0);
    const Pack a = filtered::detail::load_three(triangle.a.data()), b = filtered::detail::load_three(triangle.b.data()),
               c = filtered::detail::load_three(triangle.c.data());
    const Pack below = maximum(high - a, maximum(high - b, high - c)) + radius;
    const Pack above = radius - minimum(low - a, minimum(low - b, low - c));
    return (negative_lanes(below | above) & 0b111) != 0;
  }

 private:
  TOUCHSTONE_INLINE void set_box() {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(motion_.ball.center[axis], motion_.to[axis]);
      high_[axis] = std::max(motion_.ball.center[axis], motion_.to[axis]);
    }
  }

  Motion whole_;
  Motion motion_;  ///< the shortened one
  double low_[3], high_[3];
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

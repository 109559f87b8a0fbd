// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/polygon/exact_edges.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/signs/closest_point.h"

/// A moving ball and a prepared polygon: in the polygon's frame, in doubles, for the first stage; in double-doubles for
/// the second.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A motion in a polygon's frame.
///
/// Valid in every rounding direction and, in frames from Frame::kSubnormal up, under flush-to-zero; raises no flags
/// except INEXACT and UNDERFLOW.
struct FrameMotion {
  HeightQuery start;                     ///< the ball at time 0
  double x, y;                           ///< its foot
  Vector3<double> velocity;              ///< along the frame's axes, and its normal
  double point_error, velocity_error;    ///< of each component of edge-wise coordinates
  Bounded<Pack> height, change, radius;  ///< the same in every lane
  double size;                           ///< bounds::kLongestMotion at most, if the motion is in range

  /// Requires coordinates and a radius up to frame.reachable.
  TOUCHSTONE_INLINE FrameMotion(const Motion& motion, const Frame& frame)
      : start(motion.ball, frame),
        x(frame::coordinate(frame.x, start.to_center)),
        y(frame::coordinate(frame.y, start.to_center)) {
    const auto component = [&](int axis) {
      return frame.unit.scaled(motion.to[axis]) - frame.unit.scaled(motion.ball.center[axis]);
    };
    const Vector3<double> given{component(0), component(1), component(2)};
    const double widest =
        maximum(maximum(std::abs(given.x), std::abs(given.y)), maximum(std::abs(given.z), 1 / bounds::kLongestMotion));
    velocity = {frame::coordinate(frame.x, given), frame::coordinate(frame.y, given),
                frame::coordinate(frame.normal, given)};
    // Along an edge and across it both are known to kEdgeFrame units of what bounds the coordinates in the plane. That
    // is more than the error of heights.
    size = start.size + 2 * widest;
    point_error = bounds::kEdgeFrame * bounds::kUnit * start.size;
    velocity_error = bounds::kEdgeFrame * bounds::kUnit * (2 * widest);
    height = {all_lanes(start.height), all_lanes(start.height_error)};
    change = {all_lanes(velocity.z), all_lanes(velocity_error)};
    radius = {all_lanes(start.radius), all_lanes(0)};
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool in_range() const { return size + start.radius <= bounds::kLongestMotion / 4; }
  [[nodiscard]] TOUCHSTONE_INLINE PlaneEntry<Pack> plane() const { return plane_entry(height, change, radius); }
};

/// Returns a vector whose components are known to this error.
TOUCHSTONE_INLINE BoundedVector<Pack> known_within(const Vector3<Pack>& v, double error) {
  return {{v.x, v.y, v.z}, maximum(largest_component(v), all_lanes(1 / bounds::kLongestMotion)), all_lanes(error)};
}

/// Four edges of a leaf as seen from a motion: along the edge, across it in the plane, and along the plane's normal.
TOUCHSTONE_INLINE MovingEdge<Pack> moving_edges(const EdgeTree::Leaf& leaf, const FrameMotion& motion) {
  const Pack direction_x = load(leaf.direction_x), direction_y = load(leaf.direction_y), zero = all_lanes(0);
  const Pack start_x = load(leaf.start_x), start_y = load(leaf.start_y);
  const Pack x = all_lanes(motion.x), y = all_lanes(motion.y);
  const Pack velocity_x = all_lanes(motion.velocity.x), velocity_y = all_lanes(motion.velocity.y);
  return {known_within({frame::along(x, y, start_x, start_y, direction_x, direction_y),
                        frame::across(x, y, start_x, start_y, direction_x, direction_y), motion.height.value},
                       motion.point_error),
          known_within({load(leaf.length), zero, zero}, bounds::kFrameLength * bounds::kUnit),
          known_within({frame::turned_along(velocity_x, velocity_y, direction_x, direction_y),
                        frame::turned_across(velocity_x, velocity_y, direction_x, direction_y), motion.change.value},
                       motion.velocity_error),
          motion.radius};
}

/// The computations of a SweptDisc, over any numbers, also those that carry the bounds of their errors for the proof
/// (tests/robust/proofs/swept_disc_test.cpp).
namespace swept_disc {

/// More than the error of any coordinate of a motion, in units of its size.
inline constexpr double kMargin = 0x1p-40;

template <class N>
constexpr N margin(const N& size) {
  return constant<N>(kMargin) * size;
}

/// The times between which the height above the plane, first + t change, is at most r in magnitude, up to the margin.
template <class N>
struct Times {
  N begin, end;

  /// `speed`: the magnitude of `change`.
  TOUCHSTONE_INLINE Times(const N& first, const N& change, const N& speed, const N& radius, const N& margin) {
    const N middle = -first / change, half = (radius + margin) / speed;
    begin = maximum(middle - half, constant<N>(0));
    end = middle + half;
  }
};

/// Returns a bound of the distance between centre and plane, given one that is computed.
template <class N>
TOUCHSTONE_INLINE N least_distance(const N& computed, const N& margin) {
  return maximum(computed - margin, constant<N>(0));
}
/// Returns the radius of the disc in which a ball at this distance or farther meets the plane.
template <class N>
TOUCHSTONE_INLINE N reach(const N& radius, const N& distance, const N& margin) {
  return frame::half_chord(radius, distance) * constant<N>(bounds::kWide) + margin;
}

/// The way of a foot, from its middle and half of it.
template <class N>
struct Way {
  N middle_x, middle_y, half_x, half_y;

  static TOUCHSTONE_INLINE Way between(const N& begin, const N& end, const N& x, const N& y, const N& velocity_x,
                                       const N& velocity_y) {
    const N middle = constant<N>(0.5) * (begin + end), half = constant<N>(0.5) * (end - begin);
    return {x + middle * velocity_x, y + middle * velocity_y, half * velocity_x, half * velocity_y};
  }
  /// Returns twice the area that half of the way spans with a point at distance `reach`.
  [[nodiscard]] TOUCHSTONE_INLINE N area(const N& reach) const {
    return reach * square_root(frame::squared_length(half_x, half_y)) * constant<N>(bounds::kWide);
  }
};

/// A box as seen from a way. It has this centre, a unit axis and half sizes.
template <class N>
struct BoxFromWay {
  N beside, above;   ///< beyond what the way spans along the axis and across it
  N offset, shadow;  ///< of the centre from the way's line, and what the box spans across it, times half of the way

  TOUCHSTONE_INLINE BoxFromWay(const Way<N>& way, const N& center_x, const N& center_y, const N& axis_x,
                               const N& axis_y, const N& half_along, const N& half_across, const N& margin) {
    const N &x = way.middle_x, &y = way.middle_y, zero = constant<N>(0);
    const N along = frame::along(x, y, center_x, center_y, axis_x, axis_y);
    const N across = frame::across(x, y, center_x, center_y, axis_x, axis_y);
    const N span_along = magnitude(frame::turned_along(way.half_x, way.half_y, axis_x, axis_y));
    const N span_across = magnitude(frame::turned_across(way.half_x, way.half_y, axis_x, axis_y));
    const N wide_along = half_along + margin, wide_across = half_across + margin;
    beside = maximum(frame::beyond(along, span_along + wide_along), zero);
    above = maximum(frame::beyond(across, span_across + wide_across), zero);
    offset = magnitude((x - center_x) * way.half_y - (y - center_y) * way.half_x);
    shadow = wide_along * span_across + wide_across * span_along;
  }
  /// Returns a number that is negative only if all points of the box are farther than `reach` from the way.
  [[nodiscard]] TOUCHSTONE_INLINE N within(const N& reach) const {
    return reach * reach - frame::squared_length(beside, above);
  }
  /// The same by the distance from the way's line. `area`: of the way; `least`: covers underflow.
  [[nodiscard]] TOUCHSTONE_INLINE N astride(const N& area, const N& least) const {
    return (shadow + area) * constant<N>(1 + 0x1p-40) + least - offset;
  }
};

}  // namespace swept_disc

/// The part of the plane that a motion's ball may touch until some time: all points within `reach` of the segment that
/// the foot covers while the ball may reach the plane. Only ever too large. Requires a ball that does not touch at its
/// start: its radius is at most twice the motion's size.
class SweptDisc {
 public:
  TOUCHSTONE_INLINE explicit SweptDisc(const FrameMotion& motion)
      : motion_(motion), margin_(swept_disc::margin(motion.size)) {
    const double radius = motion.start.radius, first = motion.start.height, change = motion.velocity.z;
    if (const double speed = std::abs(change); speed > margin_) {
      const swept_disc::Times<double> times(first, change, speed, radius, margin_);
      begin_ = times.begin, end_ = times.end;
    }
    // The least height above the plane, on either side.
    const double last = first + change;
    const double least = maximum(first < last ? first : last, first < last ? -last : -first);
    reach_ = swept_disc::reach(radius, swept_disc::least_distance(least, margin_), margin_);
    end_at(1);
  }
  /// Ends the motion at this time, if it does not end before.
  TOUCHSTONE_INLINE void end_at(double time) {
    end_ = maximum(begin_, time < end_ ? time : end_);
    way_ = swept_disc::Way<double>::between(begin_, end_, motion_.x, motion_.y, motion_.velocity.x, motion_.velocity.y);
    area_ = way_.area(reach_);
  }
  /// Returns the lanes of boxes that the disc certainly misses. Each box has this centre, a unit axis and half sizes.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned misses(const Pack& center_x, const Pack& center_y, const Pack& axis_x,
                                                  const Pack& axis_y, const Pack& half_along,
                                                  const Pack& half_across) const {
    const swept_disc::Way<Pack> way{all_lanes(way_.middle_x), all_lanes(way_.middle_y), all_lanes(way_.half_x),
                                    all_lanes(way_.half_y)};
    const swept_disc::BoxFromWay<Pack> box(way, center_x, center_y, axis_x, axis_y, half_along, half_across,
                                           all_lanes(margin_));
    return negative_lanes(box.within(all_lanes(reach_))) |
           negative_lanes(box.astride(all_lanes(area_), all_lanes(margin_ * margin_)));
  }

 private:
  const FrameMotion& motion_;
  double begin_ = 0, end_ = 1;  // times
  double margin_, reach_, area_;
  swept_disc::Way<double> way_;
};

/// A motion and a prepared polygon in double-doubles, in the frame's unit of length but along the axes of the input,
/// for touched_point.h.
///
/// Requires a frame, and round to nearest without flush-to-zero during its lifetime.
template <class Counts>
class PolygonMotionDoubles {
 public:
  PolygonMotionDoubles(const Motion& motion, const PreparedPolygon::Parts& parts, Counts& counts)
      : parts_(parts), edges_(motion.ball, parts, counts), radius_(parts.frame->unit.scaled(motion.ball.radius)) {
    usable_ = edges_.scales();
    DoubleDouble velocity[3];
    for (int axis = 0; axis < 3; ++axis) {
      usable_ = usable_ && parts.frame->unit.is_exact(motion.to[axis]);
      velocity[axis] = two_difference(parts.frame->unit.scaled(motion.to[axis]), edges_.center(axis));
    }
    velocity_ = known_within({velocity[0], velocity[1], velocity[2]}, 0);
    const LiftedPolygon& lifted = parts.exact_form().lifted;
    normal_ = {lifted.normal, std::max(lifted.normal_maximum, kLeastMaximum),
               lifted.exact_normal ? 0 : bounds::kDoubleDoubleUnit * lifted.normal_maximum + bounds::kNormalUnderflow};
    planar_axis_ = lifted.exact_normal && lifted.lifts.empty() ? only_component(lifted.normal) : -1;
  }

  /// Returns whether all numbers are exact in the frame's unit of length. Nothing else may be asked if not.
  [[nodiscard]] bool usable() const { return usable_; }

  [[nodiscard]] MovingEdge<DoubleDouble> moving(std::size_t i) const {
    const auto& view = edges_.edge_view(i);
    const double lift = view.lifted ? bounds::kDoubleDoubleUnit : 0;
    return {known_within(view.to_center, lift * view.maxima.to_center),
            known_within(view.edge, lift * view.maxima.edge),
            velocity_,
            {radius_, 0}};
  }
  [[nodiscard]] const BoundedVector<DoubleDouble>& normal() const { return normal_; }
  [[nodiscard]] const Bounded<DoubleDouble>& normal_length() const {
    if (!normal_length_) normal_length_.emplace(root(dot(normal_, normal_)));
    return *normal_length_;
  }
  [[nodiscard]] double unscaled(double length) const { return edges_.unscaled(length); }
  [[nodiscard]] double center(int axis) const { return edges_.center(axis); }
  [[nodiscard]] Bounded<DoubleDouble> vertex(std::size_t i, int axis) const {
    const DoubleDouble given = edges_.vertex(i, axis);
    if (!edges_.lifts(axis)) return {given, 0};
    const DoubleDouble lifted = given + edges_.lift(i);
    return {lifted, 2 * bounds::kLift + 2 * bounds::kDoubleDoubleUnit * std::abs(given.high)};
  }
  /// Returns the coordinate of a lifted vertex as the nearest double; zero as +0.
  [[nodiscard]] std::optional<double> rounded_vertex(std::size_t i, int axis) const {
    return ClosestPointOnFeature(edges_, {Feature::Kind::Vertex, i}).coordinate(axis);
  }
  /// Returns whether all vertices have the same coordinate along an axis.
  [[nodiscard]] bool flat(int axis) const { return axis == planar_axis_; }
  /// Returns whether a component of the normal is certainly zero.
  [[nodiscard]] bool no_normal(int axis) const { return edges_.edge_view(0).no_normal(axis); }
  /// Returns whether lifts move a component of an edge along this axis that is zero as given.
  [[nodiscard]] bool lifts(int axis) const { return edges_.lifts(axis); }

 private:
  // Keeps every error above the effect of underflow (numbers/bounded.h).
  static constexpr double kLeastMaximum = 1 / bounds::kLongestMotion;
  static BoundedVector<DoubleDouble> known_within(const Vector3<DoubleDouble>& v, double error) {
    return {v, std::max(largest_component(v), kLeastMaximum), error};
  }
  /// Returns the axis of the only component that is not zero, or -1.
  static int only_component(const Vector3<DoubleDouble>& v) {
    int axis = -1;
    for (int k = 0; k < 3; ++k) {
      if (v[k].high == 0) continue;  // exact
      if (axis >= 0) return -1;
      axis = k;
    }
    return axis;
  }

  const PreparedPolygon::Parts& parts_;
  const ExactEdges<Counts> edges_;
  const double radius_;
  bool usable_;
  BoundedVector<DoubleDouble> velocity_, normal_;
  mutable std::optional<Bounded<DoubleDouble>> normal_length_;
  int planar_axis_;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

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

/// The part of the plane that a motion's ball may touch until some time: all points within `reach` of the segment that
/// the foot covers while the ball may reach the plane. Only ever too large.
class SweptDisc {
 public:
  TOUCHSTONE_INLINE explicit SweptDisc(const FrameMotion& motion) : motion_(motion) {
    margin_ = 0x1p-40 * motion.size;  // far above the error of any coordinate
    const double radius = motion.start.radius, first = motion.start.height, change = motion.velocity.z;
    // The times between which the height is at most r, up to the margin. Its errors are far below the margin, too.
    if (const double speed = std::abs(change); speed > margin_) {
      const double middle = -first / change, half = (radius + margin_) / speed;
      begin_ = maximum(middle - half, 0);
      end_ = middle + half;
    }
    // The least height above the plane, on either side.
    const double last = first + change;
    const double low = maximum(maximum(first < last ? first : last, first < last ? -last : -first) - margin_, 0);
    reach_ = frame::half_chord(radius, low) * bounds::kWide + margin_;
    end_at(1);
  }
  /// Ends the motion at this time, if it does not end before.
  TOUCHSTONE_INLINE void end_at(double time) {
    end_ = maximum(begin_, time < end_ ? time : end_);
    const double middle = 0.5 * (begin_ + end_), half = 0.5 * (end_ - begin_);
    middle_x_ = motion_.x + middle * motion_.velocity.x, half_x_ = half * motion_.velocity.x;
    middle_y_ = motion_.y + middle * motion_.velocity.y, half_y_ = half * motion_.velocity.y;
    // Twice the area that the foot's half segment spans with a point at distance `reach`.
    reach_area_ = reach_ * std::sqrt(half_x_ * half_x_ + half_y_ * half_y_) * bounds::kWide;
  }
  /// Returns the lanes of boxes that the disc certainly misses. Each box has this centre, a unit axis and half sizes.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned misses(const Pack& center_x, const Pack& center_y, const Pack& axis_x,
                                                  const Pack& axis_y, const Pack& half_along,
                                                  const Pack& half_across) const {
    const Pack x = all_lanes(middle_x_), y = all_lanes(middle_y_), zero = all_lanes(0);
    const Pack half_x = all_lanes(half_x_), half_y = all_lanes(half_y_), margin = all_lanes(margin_);
    const Pack along = frame::along(x, y, center_x, center_y, axis_x, axis_y);
    const Pack across = frame::across(x, y, center_x, center_y, axis_x, axis_y);
    const Pack span_along = magnitude(frame::turned_along(half_x, half_y, axis_x, axis_y));
    const Pack span_across = magnitude(frame::turned_across(half_x, half_y, axis_x, axis_y));
    const Pack wide_along = half_along + margin, wide_across = half_across + margin;
    const Pack beside = maximum(frame::beyond(along, span_along + wide_along), zero);
    const Pack above = maximum(frame::beyond(across, span_across + wide_across), zero);
    const Pack reach = all_lanes(reach_);
    const unsigned apart = negative_lanes(reach * reach - frame::squared_length(beside, above));
    // The same across the segment: the distance of the boxes from its line, times its half length.
    const Pack offset = magnitude((x - center_x) * half_y - (y - center_y) * half_x);
    const Pack shadow = wide_along * span_across + wide_across * span_along;
    return apart | negative_lanes((shadow + all_lanes(reach_area_)) * all_lanes(1 + 0x1p-40) +
                                  all_lanes(margin_ * margin_) - offset);
  }

 private:
  const FrameMotion& motion_;
  double begin_ = 0, end_ = 1;  // times
  double margin_, reach_, reach_area_;
  double middle_x_, middle_y_, half_x_, half_y_;
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

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/polygon/exact_edges.h"
#include "robust/filtered/detail/signs/closest_point.h"

namespace touchstone::filtered::detail {
inline namespace TOUCHSTONE_TARGET {

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

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/motion/motion_view.h"
#include "robust/filtered/detail/motion/moving_edge.h"

/// The first stage for a moving ball and a triangle: all events in doubles, one edge a lane.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// The vectors of a motion and a triangle, one edge a lane.
struct TriangleMotionLanes {
  MovingEdge<Pack> moving;
  BoundedVector<Pack> normal;
  Bounded<Pack> height, change, reach;  ///< for plane_entry

  TOUCHSTONE_INLINE explicit TriangleMotionLanes(const MotionTriangleView& view);
  /// Returns whether all numbers are small enough.
  [[nodiscard]] static TOUCHSTONE_INLINE bool in_range(const MotionTriangleView& view);
};

/// Returns the difference of two points whose coordinates are doubles.
TOUCHSTONE_INLINE BoundedVector<Pack> rounded_difference(const Vector3<Pack>& a, const Vector3<Pack>& b) {
  const Vector3<Pack> difference{a.x - b.x, a.y - b.y, a.z - b.z};
  const Pack maximum_of = maximum(largest_component(difference), all_lanes(1 / bounds::kLongestMotion));
  return {difference, maximum_of, all_lanes(bounds::kUnit) * maximum_of};
}

TOUCHSTONE_INLINE bool TriangleMotionLanes::in_range(const MotionTriangleView& view) {
  Vector3<Pack> vertex;
  load_three_points(view.vertex[0], vertex.x, vertex.y, vertex.z);
  const Pack input = maximum(largest_component(vertex),
                             maximum(magnitude(load(view.motion)), magnitude(load_three(view.motion + 4))));
  return negative_lanes(all_lanes(bounds::kLongestMotion / 2) - input) == 0;
}

TOUCHSTONE_INLINE TriangleMotionLanes::TriangleMotionLanes(const MotionTriangleView& view) {
  Vector3<Pack> vertex;
  load_three_points(view.vertex[0], vertex.x, vertex.y, vertex.z);
  const auto point = [](const double* p) { return Vector3<Pack>{all_lanes(p[0]), all_lanes(p[1]), all_lanes(p[2])}; };
  const Vector3<Pack> center = point(view.motion), to = point(view.motion + 4);
  const Vector3<Pack> next{next_of_three(vertex.x), next_of_three(vertex.y), next_of_three(vertex.z)};
  const Vector3<Pack> previous{previous_of_three(vertex.x), previous_of_three(vertex.y), previous_of_three(vertex.z)};
  moving = {rounded_difference(center, vertex), rounded_difference(next, vertex), rounded_difference(to, center),
            {all_lanes(view.radius()), all_lanes(0)}};
  normal = cross(moving.edge, rounded_difference(previous, vertex));
  height = dot(normal, moving.to_center), change = dot(normal, moving.velocity);
  reach = moving.radius * root(dot(normal, normal));
}

/// The events of a motion at a triangle, one edge and its start a lane. Every lane of `face` is the same event.
struct TriangleEvents {
  Entry<Pack> start, interior, face;
  static constexpr unsigned all = 0b111;

  [[nodiscard]] TOUCHSTONE_INLINE bool any() const { return ((start.certain | interior.certain | face.certain) & all) != 0; }
  [[nodiscard]] TOUCHSTONE_INLINE bool unsure() const {
    return (start.unsure(all) | interior.unsure(all) | face.unsure(1)) != 0;
  }
};

/// Returns the event of the face's interior.
TOUCHSTONE_INLINE Entry<Pack> face_event(const TriangleMotionLanes& lanes, const Entry<Pack>& plane) {
  // Seen from the front the foot is left of edge e if N.(e x (w + t d)) > 0.
  const Bounded<Pack> side = dot(lanes.normal, cross(lanes.moving.edge, lanes.moving.to_center)) +
                             plane.time * dot(lanes.normal, cross(lanes.moving.edge, lanes.moving.velocity));
  constexpr unsigned all = TriangleEvents::all;
  const bool happens = (plane.certain & all) != 0;
  const bool outside = happens && (negative(side) & plane.certain & all) != 0;
  const bool inside = (plane.certain & positive(side) & all) == all;
  return {(plane.none & all) != 0 || outside ? ~0U : 0U, inside ? ~0U : 0U, plane.time};
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

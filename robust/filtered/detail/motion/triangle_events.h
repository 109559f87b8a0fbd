// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/motion/motion_view.h"
#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/triangle_filter.h"

/// The first stage for a moving ball and a triangle: all events in doubles, one edge a lane.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Returns a vector whose components are known to kUnit of the largest one.
TOUCHSTONE_INLINE BoundedVector<Pack> rounded_vector(const Vector3<Pack>& v) {
  const Pack largest = maximum(largest_component(v), all_lanes(1 / bounds::kLongestMotion));
  return {{v.x, v.y, v.z}, largest, all_lanes(bounds::kUnit) * largest};
}

/// The vectors of a motion and a triangle, one edge a lane. Requires numbers of at most bounds::kLongestMotion / 2.
struct TriangleMotionLanes {
  MovingEdge<Pack> moving;
  BoundedVector<Pack> normal;

  TOUCHSTONE_INLINE TriangleMotionLanes(const Vector3<Pack>& vertex, const MotionTriangleView& view) {
    const Vector3<Pack> center = point_lanes(view.motion);
    const Vector3<Pack> next{next_of_three(vertex.x), next_of_three(vertex.y), next_of_three(vertex.z)};
    const Vector3<Pack> previous{previous_of_three(vertex.x), previous_of_three(vertex.y), previous_of_three(vertex.z)};
    moving = {rounded_vector(difference(center, vertex)),
              rounded_vector(difference(next, vertex)),
              rounded_vector(difference(point_lanes(view.motion + 4), center)),
              {all_lanes(view.radius()), all_lanes(0)}};
    normal = cross(moving.edge, rounded_vector(difference(previous, vertex)));
  }
  /// Returns when the height above the plane falls to r.
  [[nodiscard]] TOUCHSTONE_INLINE PlaneEntry<Pack> plane() const {
    return plane_entry(dot(normal, moving.to_center), dot(normal, moving.velocity),
                       moving.radius * root(dot(normal, normal)));
  }
};

/// The events of a triangle that the first stage does not exclude, one bit an edge or its start.
struct PossibleEvents {
  unsigned starts = 0b111, interiors = 0b111;
  bool face = true;
};

/// The events of a motion at a triangle, one edge and its start a lane. Every lane of `face` is the same event.
struct TriangleEvents {
  Entry<Pack> start, interior, face;
  static constexpr unsigned all = 0b111;

  [[nodiscard]] TOUCHSTONE_INLINE bool any() const {
    return ((start.certain | interior.certain | face.certain) & all) != 0;
  }
  [[nodiscard]] TOUCHSTONE_INLINE PossibleEvents possible() const {
    return {~start.none & all, ~interior.none & all, (face.none & 1) == 0};
  }
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

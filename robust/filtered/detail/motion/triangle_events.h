// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "robust/filtered/detail/motion/moving_edge.h"
#include "robust/filtered/detail/motion/touched_point.h"
#include "robust/filtered/detail/numbers/length_unit.h"
#include "robust/filtered/detail/signs/closest_point.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/detail/triangle/triangle_filter.h"

/// The second stage for a moving ball and a triangle: its events, and the time and point of one, in double-doubles.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// The first stage for a moving ball and a triangle: all events in doubles, one edge a lane.

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

/// Returns the events of a degenerate triangle: those of its ends and of the edge between them, each by the lowest
/// number.
inline PossibleEvents events_of_ends(const double (*vertex)[3]) {
  const auto before = [vertex](int i, int j) {
    return std::lexicographical_compare(vertex[i], vertex[i] + 3, vertex[j], vertex[j] + 3);
  };
  int low = 0, high = 0;
  for (const int i : {1, 2}) {
    if (before(i, low)) low = i;
    if (before(high, i)) high = i;
  }
  PossibleEvents events{1U << low | 1U << high, 0, false};
  const auto at = [&before](int i, int end) { return !before(i, end) && !before(end, i); };
  for (int i = 2; i >= 0 && low != high; --i) {
    const int next = i == 2 ? 0 : i + 1;
    if ((at(i, low) && at(next, high)) || (at(i, high) && at(next, low))) events.interiors = 1U << i;
  }
  return events;
}

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

/// A motion and a triangle in double-doubles. Differences are exact. Requires round to nearest, and numbers of at most
/// bounds::kLongestMotion / 2.
class TriangleMotionDoubles {
 public:
  /// The unit is null if lengths are those of the caller.
  TriangleMotionDoubles(const MotionTriangleView& view, const LengthUnit* unit)
      : view_(view),
        unit_(unit),
        edges_{difference(view.vertex[1], view.vertex[0]), difference(view.vertex[2], view.vertex[1]),
               difference(view.vertex[0], view.vertex[2])},
        velocity_(difference(view.motion + 4, view.motion)),
        normal_(cross(edges_[0], edges_[1])) {}

  /// Returns the edge i as seen from the motion.
  [[nodiscard]] MovingEdge<DoubleDouble> moving(std::size_t i) const {
    return {difference(view_.motion, view_.vertex[i]), edges_[i], velocity_, {view_.radius(), 0}};
  }
  [[nodiscard]] double unscaled(double length) const { return unit_ != nullptr ? unit_->unscaled(length) : length; }
  [[nodiscard]] const BoundedVector<DoubleDouble>& normal() const { return normal_; }
  [[nodiscard]] const Bounded<DoubleDouble>& normal_length() const {
    if (!normal_length_) normal_length_.emplace(root(dot(normal_, normal_)));
    return *normal_length_;
  }
  [[nodiscard]] double center(int axis) const { return view_.center(axis); }
  [[nodiscard]] Bounded<DoubleDouble> vertex(std::size_t i, int axis) const { return {view_.vertex[i][axis], 0}; }
  /// Returns the coordinate of a vertex as given; zero as +0.
  [[nodiscard]] std::optional<double> rounded_vertex(std::size_t i, int axis) const {
    return unscaled(view_.vertex[i][axis]) + 0.0;
  }
  /// Returns whether all vertices have the same coordinate along an axis, exactly.
  [[nodiscard]] bool flat(int axis) const {
    return view_.vertex[0][axis] == view_.vertex[1][axis] && view_.vertex[0][axis] == view_.vertex[2][axis];  // exact
  }

  /// Returns whether a component of the normal is certainly zero.
  [[nodiscard]] bool no_normal(int axis) const {
    return certainly_zero(edges_[0].value, edges_[1].value, normal_.value, axis);
  }
  /// Returns whether vertices are lifted along this axis.
  [[nodiscard]] static bool lifts(int) { return false; }

  /// Returns the event of the face's interior.
  [[nodiscard]] Entry<DoubleDouble> face_event() const {
    Entry<DoubleDouble> event = face_entry(*this).entry;
    for (std::size_t i = 0; i < 3 && event.certain != 0; ++i) {
      const MovingEdge<DoubleDouble> edge = moving(i);
      const auto side =
          dot(normal_, cross(edge.edge, edge.to_center)) + event.time * dot(normal_, cross(edge.edge, edge.velocity));
      if (negative(side) != 0) event.none = 1;
      event.certain &= positive(side);
    }
    return event;
  }

  /// Sets the first event among the possible ones, or any event if `any`. Returns Yes if it is certain which one that
  /// is, and No if it is certain that no event happens.
  template <bool any = false>
  [[nodiscard]] FilterResult find_first(const PossibleEvents& possible, FirstCandidate<DoubleDouble>& first) const {
    bool unsure = false;
    const auto consider = [&](Feature::Kind kind, std::size_t i, const Entry<DoubleDouble>& event) {
      unsure = unsure || event.unsure(1) != 0;
      if ((event.certain & 1) != 0) first.add({kind, i}, event.time.value, event.time.error);
    };
    if (possible.face) consider(Feature::Kind::Face, 0, face_event());
    for (std::size_t i = 0; i < 3; ++i) {
      if ((possible.interiors >> i & 1) != 0) consider(Feature::Kind::Edge, i, interior_event(moving(i)));
      if ((possible.starts >> i & 1) != 0) consider(Feature::Kind::Vertex, i, start_event(moving(i)));
    }
    return first.template known<any>(unsure);
  }

 private:
  static BoundedVector<DoubleDouble> difference(const double* a, const double* b) {
    const Vector3<DoubleDouble> exact{two_difference(a[0], b[0]), two_difference(a[1], b[1]),
                                      two_difference(a[2], b[2])};
    return {exact, std::max(largest_component(exact), 1 / bounds::kLongestMotion), 0};
  }

  const MotionTriangleView view_;
  const LengthUnit* const unit_;
  BoundedVector<DoubleDouble> edges_[3], velocity_, normal_;
  mutable std::optional<Bounded<DoubleDouble>> normal_length_;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

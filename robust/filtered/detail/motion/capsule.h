// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"
#include "robust/filtered/detail/triangle/triangle_filter.h"

/// The second stage for the contact of a moving ball with a triangle: the signs that doubles leave open, in
/// double-doubles.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// The first stage for the contact of a moving ball with a triangle, that is, of a capsule: signs alone, without roots
// and divisions.

/// Returns whether motion and triangle are small enough for lanes whose numbers are at most `limit`.
TOUCHSTONE_INLINE bool in_range(const Vector3<Pack>& vertex, const MotionTriangleView& view, double limit) {
  const Pack input =
      maximum(largest_component(vertex), maximum(magnitude(load(view.motion)), magnitude(load_three(view.motion + 4))));
  return negative_lanes(all_lanes(limit / 2) - input) == 0;
}

/// The decisions that doubles leave open, one bit a lane.
struct CapsuleSigns {
  FilterResult at_start, at_end;  ///< the contact at the ends of the motion
  unsigned vertices, edges;       ///< the lanes in which a vertex, or an edge's interior, may be hit
  bool may_pierce;                ///< whether the motion's segment may pierce the triangle
  double center[4], edge[4];      ///< maxima
  double velocity;                ///< maximum
};

/// Returns whether the capsule touches the triangle, if doubles can decide it. Writes `signs` if they cannot, and
/// `signs.at_start` if it touches.
///
/// The distance of the segment from the triangle is 0 if the segment pierces the triangle. Else it is that of one of
/// the segment's ends from the triangle, of a vertex from the segment's interior, or of an edge's interior from the
/// segment's interior.
TOUCHSTONE_INLINE FilterResult capsule_filter(const MotionTriangleView& view, CapsuleSigns& signs) {
  const Vector3<Pack> vertex = vertex_lanes(view.vertex);
  if (!in_range(vertex, view, bounds::kLargest)) [[unlikely]]
    return FilterResult::OutOfRange;
  const TriangleLanes triangle = triangle_lanes(vertex);
  const Vector3<Pack>&edge = triangle.edge, &normal = triangle.normal;
  const Pack &m_edge = triangle.m_edge, &m_normal = triangle.m_normal;
  const Vector3<Pack> center = point_lanes(view.motion), to = point_lanes(view.motion + 4);
  const Pack radius = all_lanes(view.radius());
  constexpr unsigned all = BallAtTriangle<>::all;
  const auto lanes = BallAtTriangle<>::lanes;

  const BallAtTriangle<> start(triangle, difference(center, vertex), radius);
  const BallAtTriangle<> end(triangle, difference(to, vertex), radius);
  const auto front = [&](const BallAtTriangle<>& ball) {
    return certain_signs(signs::front(normal, ball.to_center), bounds::kFront, m_normal * ball.m_center);
  };
  const LaneSigns starts_front = front(start), ends_front = front(end);
  const Pack stays = (starts_front.positive & ends_front.positive) | (starts_front.negative & ends_front.negative);
  const Pack crosses = (starts_front.positive & ends_front.negative) | (starts_front.negative & ends_front.positive);
  if (lanes(stays & start.plane_out.positive & end.plane_out.positive) != 0) return FilterResult::No;

  const Vector3<Pack> velocity = difference(to, center);
  const Pack m_velocity = not_too_small(largest_component(velocity));
  const Pack m_center = maximum(start.m_center, end.m_center);

  // A vertex and the motion's segment, as an edge and a centre.
  const Pack m_vertex = m_center * m_velocity;
  const LaneSigns approaches = certain_signs(signs::along(start.to_center, velocity), bounds::kAlong, m_vertex);
  const LaneSigns departs = certain_signs(signs::along(end.to_center, velocity), bounds::kAlong, m_vertex);
  const LaneSigns vertex_out =
      certain_signs(signs::line(start.to_center, velocity, radius), bounds::kLine, m_vertex * m_vertex);
  const Pack vertex_hit = vertex_out.negative & approaches.negative & departs.positive;
  const Pack vertex_missed = vertex_out.positive | approaches.positive | departs.negative;

  // An edge and the motion's segment.
  const Vector3<Pack> from_end = next_of_three(start.to_center);
  const Pack m_start = maximum(m_center, next_of_three(m_center)), m_both = m_velocity * m_edge;
  const Pack m_all = m_start * m_both, m_edge_sign = m_all * m_velocity, m_way_sign = m_all * m_edge;
  const LaneSigns apart = certain_signs(signs::apart(start.to_center, edge, velocity), bounds::kApart, m_all);
  const LaneSigns lines_out =
      certain_signs(signs::lines(start.to_center, edge, velocity, radius), bounds::kLines, m_all * m_all);
  const LaneSigns after_start =
      certain_signs(signs::on_edge(start.to_center, edge, velocity), bounds::kOnEdge, m_edge_sign);
  const LaneSigns after_end = certain_signs(signs::on_edge(from_end, edge, velocity), bounds::kOnEdge, m_edge_sign);
  const LaneSigns starts_past =
      certain_signs(signs::on_way(start.to_center, edge, velocity), bounds::kOnWay, m_way_sign);
  const LaneSigns ends_past = certain_signs(signs::on_way(end.to_center, edge, velocity), bounds::kOnWay, m_way_sign);
  const Pack edge_hit =
      lines_out.negative & after_start.positive & after_end.negative & starts_past.negative & ends_past.positive;
  const Pack beyond = end.m_center + m_velocity, m_ahead = m_edge * (beyond + beyond);
  const Vector3<Pack> ahead{end.to_center.x + velocity.x, end.to_center.y + velocity.y, end.to_center.z + velocity.z};
  const LaneSigns ahead_out =
      certain_signs(signs::line_ahead(start.to_center, ahead, edge, radius), bounds::kLineAhead, m_ahead * m_ahead);
  const Pack edge_missed = (start.line_out.positive & ahead_out.positive) | lines_out.positive | after_start.negative |
                           after_end.positive | starts_past.positive | ends_past.negative;

  const unsigned left = lanes(apart.positive), right = lanes(apart.negative);
  const bool pierces = (left == all || right == all) && lanes(crosses) != 0;
  const bool passes_by = (left != 0 && right != 0) || lanes(stays) != 0;

  // Without branches, which random motions would mispredict.
  const unsigned hit = lanes(vertex_hit | edge_hit), missed = lanes(vertex_missed & edge_missed);
  const bool touches_start = start.certainly_touches(), touches_end = end.certainly_touches();
  const bool misses_start = start.certainly_misses(), misses_end = end.certainly_misses();
  const bool yes = touches_start | touches_end | (hit != 0) | pierces;
  const bool no = misses_start & misses_end & (missed == all) & passes_by;
  signs.at_start = touches_start ? FilterResult::Yes : misses_start ? FilterResult::No : FilterResult::Unsure;
  if (yes != no) [[likely]]
    return yes ? FilterResult::Yes : FilterResult::No;
  signs.at_end = misses_end ? FilterResult::No : FilterResult::Unsure;
  signs.vertices = lanes(vertex_missed) ^ all, signs.edges = lanes(edge_missed) ^ all;
  signs.may_pierce = !passes_by;
  store(signs.center, maximum(m_start, beyond));
  store(signs.edge, m_edge);
  double velocities[kLanes];
  store(velocities, m_velocity);
  signs.velocity = velocities[0];
  return FilterResult::Unsure;
}

/// Decides with the signs of signs.h what may be hit. A sign that is not certain is 0.
class CapsuleInDoubles {
 public:
  /// Requires round to nearest.
  CapsuleInDoubles(const MotionTriangleView& view, const CapsuleSigns& signs)
      : view_(view), signs_(signs), velocity_(difference(view.motion + 4, view.motion)) {}

  [[nodiscard]] FilterResult vertex(int i) const {
    const double maximum = signs_.center[i] * signs_.velocity;
    const auto to_center = from(i), to_end = from_end(i);
    const int approaches = sign(signs::along(to_center, velocity_), bounds::kAlong * maximum);
    const int departs = sign(signs::along(to_end, velocity_), bounds::kAlong * maximum);
    if (approaches > 0 || departs < 0) return FilterResult::No;
    return hit(sign(signs::line(to_center, velocity_, radius()), bounds::kLine * maximum * maximum),
               approaches < 0 && departs > 0);
  }
  [[nodiscard]] FilterResult edge(int i) const {
    const double all = signs_.center[i] * signs_.edge[i] * signs_.velocity;
    const double edge_bound = bounds::kOnEdge * (all * signs_.velocity);
    const double way_bound = bounds::kOnWay * (all * signs_.edge[i]);
    const int next = i == 2 ? 0 : i + 1;
    const auto to_center = from(i), to_end = from_end(i), edge = difference(view_.vertex[next], view_.vertex[i]);
    const int after_start = sign(signs::on_edge(to_center, edge, velocity_), edge_bound);
    const int after_end = sign(signs::on_edge(from(next), edge, velocity_), edge_bound);
    const int starts_past = sign(signs::on_way(to_center, edge, velocity_), way_bound);
    const int ends_past = sign(signs::on_way(to_end, edge, velocity_), way_bound);
    if (after_start < 0 || after_end > 0 || starts_past > 0 || ends_past < 0) return FilterResult::No;
    return hit(sign(signs::lines(to_center, edge, velocity_, radius()), bounds::kLines * all * all),
               after_start > 0 && after_end < 0 && starts_past < 0 && ends_past > 0);
  }

 private:
  static Vector3<DoubleDouble> difference(const double* a, const double* b) {
    return {two_difference(a[0], b[0]), two_difference(a[1], b[1]), two_difference(a[2], b[2])};
  }
  [[nodiscard]] Vector3<DoubleDouble> from(int i) const { return difference(view_.motion, view_.vertex[i]); }
  [[nodiscard]] Vector3<DoubleDouble> from_end(int i) const { return difference(view_.motion + 4, view_.vertex[i]); }
  [[nodiscard]] DoubleDouble radius() const { return view_.radius(); }
  /// Returns the sign of a value with error `bound` kDoubleDoubleUnit + kTiny.
  static int sign(const DoubleDouble& value, double bound) {
    const double largest = bounds::kDoubleDoubleUnit * bound + bounds::kTiny;
    return (value.high > largest) - (value.high < -largest);
  }
  /// `out`: the sign of the gap; `within`: whether the nearest points certainly lie inside.
  static FilterResult hit(int out, bool within) {
    if (out > 0) return FilterResult::No;
    return out < 0 && within ? FilterResult::Yes : FilterResult::Unsure;
  }

  const MotionTriangleView& view_;
  const CapsuleSigns& signs_;
  const Vector3<DoubleDouble> velocity_;
};

/// Returns whether the capsule touches the triangle, if double-doubles can decide it. Requires round to nearest.
template <class Counts>
FilterResult unsure_capsule(const MotionTriangleView& view, const CapsuleSigns& signs, Counts& counts) {
  const double end[] = {view.to(0), view.to(1), view.to(2), view.radius()};
  if (signs.at_start != FilterResult::No && contact(BallTriangleView{view.vertex, view.motion}, counts))
    return FilterResult::Yes;
  if (signs.at_end != FilterResult::No && contact(BallTriangleView{view.vertex, end}, counts)) return FilterResult::Yes;
  const CapsuleInDoubles capsule(view, signs);
  bool unsure = signs.may_pierce, touches = false;
  const auto consider = [&](FilterResult result) {
    touches = result == FilterResult::Yes;
    unsure = unsure || result == FilterResult::Unsure;
  };
  for (unsigned edges = signs.edges; edges != 0 && !touches; edges &= edges - 1)
    consider(capsule.edge(std::countr_zero(edges)));
  for (unsigned vertices = signs.vertices; vertices != 0 && !touches; vertices &= vertices - 1)
    consider(capsule.vertex(std::countr_zero(vertices)));
  if (!touches && unsure) return FilterResult::Unsure;
  counts.count(Stage::DoubleDouble);
  return touches ? FilterResult::Yes : FilterResult::No;
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

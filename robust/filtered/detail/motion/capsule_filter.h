// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/motion/motion_view.h"
#include "robust/filtered/detail/triangle_filter.h"

/// The first stage for the contact of a moving ball with a triangle, that is, of a capsule: signs alone, without roots
/// and divisions.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

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

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

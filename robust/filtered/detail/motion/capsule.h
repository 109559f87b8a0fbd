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

/// The ends of a motion as seen from a triangle's corners and edges, with the sides of the plane on which they lie.
template <class P>
struct CapsuleEnds {
  BallAtTriangle<P> start, end;
  LaneSigns<P> starts_front, ends_front;

  TOUCHSTONE_INLINE CapsuleEnds(const TriangleLanes<P>& triangle, const Vector3<P>& vertex, const Vector3<P>& center,
                                const Vector3<P>& to, const P& radius)
      : start(triangle, difference(center, vertex), radius),
        end(triangle, difference(to, vertex), radius),
        starts_front(front(triangle, start)),
        ends_front(front(triangle, end)) {}

  [[nodiscard]] TOUCHSTONE_INLINE P stays() const {
    return (starts_front.positive & ends_front.positive) | (starts_front.negative & ends_front.negative);
  }
  [[nodiscard]] TOUCHSTONE_INLINE P crosses() const {
    return (starts_front.positive & ends_front.negative) | (starts_front.negative & ends_front.positive);
  }
  /// Returns whether the plane certainly misses the whole capsule.
  [[nodiscard]] bool miss_plane() const {
    return BallAtTriangle<P>::lanes(stays() & start.plane_out.positive & end.plane_out.positive) != 0;
  }

 private:
  static TOUCHSTONE_INLINE LaneSigns<P> front(const TriangleLanes<P>& triangle, const BallAtTriangle<P>& ball) {
    return certain_signs(signs::front(triangle.normal, ball.to_center), bounds::kFront,
                         triangle.m_normal * ball.m_center);
  }
};

/// The segment of a motion between its ends, as seen from a triangle's corners and edges.
template <class P>
struct CapsuleSide {
  P m_velocity, m_start, beyond;                 ///< maxima
  LaneSigns<P> approaches, departs, vertex_out;  ///< a vertex, with the segment as an edge
  /// An edge.
  LaneSigns<P> apart, lines_out, after_start, after_end, starts_past, ends_past, ahead_out;

  TOUCHSTONE_INLINE CapsuleSide(const TriangleLanes<P>& triangle, const CapsuleEnds<P>& ends,
                                const Vector3<P>& velocity, const P& radius)
      : m_velocity(not_too_small(largest_component(velocity))) {
    const auto &start = ends.start, &end = ends.end;
    const Vector3<P>& edge = triangle.edge;
    const P m_center = maximum(start.m_center, end.m_center), m_vertex = m_center * m_velocity;
    approaches = certain_signs(signs::along(start.to_center, velocity), bounds::kAlong, m_vertex);
    departs = certain_signs(signs::along(end.to_center, velocity), bounds::kAlong, m_vertex);
    vertex_out = certain_signs(signs::line(start.to_center, velocity, radius), bounds::kLine, m_vertex * m_vertex);

    const Vector3<P> from_end = next_of_three(start.to_center);
    m_start = maximum(m_center, next_of_three(m_center));
    const P m_all = m_start * (m_velocity * triangle.m_edge);
    const P m_edge_sign = m_all * m_velocity, m_way_sign = m_all * triangle.m_edge;
    apart = certain_signs(signs::apart(start.to_center, edge, velocity), bounds::kApart, m_all);
    lines_out = certain_signs(signs::lines(start.to_center, edge, velocity, radius), bounds::kLines, m_all * m_all);
    after_start = certain_signs(signs::on_edge(start.to_center, edge, velocity), bounds::kOnEdge, m_edge_sign);
    after_end = certain_signs(signs::on_edge(from_end, edge, velocity), bounds::kOnEdge, m_edge_sign);
    starts_past = certain_signs(signs::on_way(start.to_center, edge, velocity), bounds::kOnWay, m_way_sign);
    ends_past = certain_signs(signs::on_way(end.to_center, edge, velocity), bounds::kOnWay, m_way_sign);
    beyond = end.m_center + m_velocity;
    const P m_ahead = triangle.m_edge * (beyond + beyond);
    const Vector3<P> ahead{end.to_center.x + velocity.x, end.to_center.y + velocity.y, end.to_center.z + velocity.z};
    ahead_out =
        certain_signs(signs::line_ahead(start.to_center, ahead, edge, radius), bounds::kLineAhead, m_ahead * m_ahead);
  }

  [[nodiscard]] TOUCHSTONE_INLINE P vertex_hit() const {
    return vertex_out.negative & approaches.negative & departs.positive;
  }
  [[nodiscard]] TOUCHSTONE_INLINE P vertex_missed() const {
    return vertex_out.positive | approaches.positive | departs.negative;
  }
  [[nodiscard]] TOUCHSTONE_INLINE P edge_hit() const {
    return lines_out.negative & after_start.positive & after_end.negative & starts_past.negative & ends_past.positive;
  }
  /// `start_out`: the sign of the edge's line as seen from the start.
  [[nodiscard]] TOUCHSTONE_INLINE P edge_missed(const LaneSigns<P>& start_out) const {
    return (start_out.positive & ahead_out.positive) | lines_out.positive | after_start.negative | after_end.positive |
           starts_past.positive | ends_past.negative;
  }
};

/// Returns whether the capsule touches the triangle, if its signs decide it. Writes the decisions that they leave open.
///
/// The distance of the segment from the triangle is 0 if the segment pierces the triangle. Else it is that of one of
/// the segment's ends from the triangle, of a vertex from the segment's interior, or of an edge's interior from the
/// segment's interior.
TOUCHSTONE_INLINE FilterResult decide(const CapsuleEnds<Pack>& ends, const CapsuleSide<Pack>& side,
                                      CapsuleSigns& signs) {
  constexpr unsigned all = BallAtTriangle<Pack>::all;
  const auto lanes = BallAtTriangle<Pack>::lanes;
  const auto &start = ends.start, &end = ends.end;
  const Pack vertex_missed = side.vertex_missed(), edge_missed = side.edge_missed(start.line_out);
  const unsigned left = lanes(side.apart.positive), right = lanes(side.apart.negative);
  const bool pierces = (left == all || right == all) && lanes(ends.crosses()) != 0;
  const bool passes_by = (left != 0 && right != 0) || lanes(ends.stays()) != 0;

  // Without branches, which random motions would mispredict.
  const unsigned hit = lanes(side.vertex_hit() | side.edge_hit()), missed = lanes(vertex_missed & edge_missed);
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
  return FilterResult::Unsure;
}

/// Returns whether the capsule touches the triangle, if doubles can decide it. Writes `signs` if they cannot, and
/// `signs.at_start` if it touches.
TOUCHSTONE_INLINE FilterResult capsule_filter(const MotionTriangleView& view, CapsuleSigns& signs) {
  const Vector3<Pack> vertex = vertex_lanes(view.vertex);
  if (!in_range(vertex, view, bounds::kLargest)) [[unlikely]]
    return FilterResult::OutOfRange;
  const TriangleLanes<Pack> triangle = triangle_lanes(vertex);
  const Vector3<Pack> center = point_lanes(view.motion), to = point_lanes(view.motion + 4);
  const Pack radius = all_lanes(view.radius());
  const CapsuleEnds<Pack> ends(triangle, vertex, center, to, radius);
  if (ends.miss_plane()) return FilterResult::No;
  const CapsuleSide<Pack> side(triangle, ends, difference(to, center), radius);
  const FilterResult result = decide(ends, side, signs);
  if (result == FilterResult::Unsure) {
    store(signs.center, maximum(side.m_start, side.beyond));
    store(signs.edge, triangle.m_edge);
    double velocities[kLanes];
    store(velocities, side.m_velocity);
    signs.velocity = velocities[0];
  }
  return result;
}

// The same in double-doubles. Vertices, edges and maxima of one lane; a sign that is not certain is 0.

/// `out`: the sign of the gap; `within`: whether the nearest points certainly lie inside.
inline FilterResult hit(int out, bool within) {
  if (out > 0) return FilterResult::No;
  return out < 0 && within ? FilterResult::Yes : FilterResult::Unsure;
}
/// Returns whether a CapsuleVertex, or whatever has its signs, is hit.
template <class Vertex>
FilterResult is_vertex_hit(const Vertex& vertex) {
  const int begins = vertex.approaches().sign(), ends = vertex.departs().sign();
  return begins > 0 || ends < 0 ? FilterResult::No : hit(vertex.out().sign(), begins < 0 && ends > 0);
}
/// Returns whether a CapsuleEdge, or whatever has its signs, is hit.
template <class Edge>
FilterResult is_edge_hit(const Edge& edge) {
  const int start = edge.after_start().sign(), end = edge.after_end().sign();
  const int starts = edge.starts_past().sign(), ends = edge.ends_past().sign();
  if (start < 0 || end > 0 || starts > 0 || ends < 0) return FilterResult::No;
  return hit(edge.out().sign(), start > 0 && end < 0 && starts < 0 && ends > 0);
}

/// A vertex and a motion's segment.
template <class Value, class Number>
struct CapsuleVertex {
  Vector3<Value> to_center, to_end, velocity;
  Value radius;
  Number most;  ///< the maximum of centres, times that of the velocity

  [[nodiscard]] Estimate<Number> approaches() const {
    return estimate(signs::along(to_center, velocity), bounds::kAlong * most);
  }
  [[nodiscard]] Estimate<Number> departs() const {
    return estimate(signs::along(to_end, velocity), bounds::kAlong * most);
  }
  [[nodiscard]] Estimate<Number> out() const {
    return estimate(signs::line(to_center, velocity, radius), bounds::kLine * most * most);
  }
};

/// An edge and a motion's segment.
template <class Value, class Number>
struct CapsuleEdge {
  Vector3<Value> to_center, from_next, to_end, edge, velocity;
  Value radius;
  Number m_center, m_edge, m_velocity;

  [[nodiscard]] Number all() const { return m_center * m_edge * m_velocity; }
  [[nodiscard]] Estimate<Number> after_start() const {
    return estimate(signs::on_edge(to_center, edge, velocity), bounds::kOnEdge * (all() * m_velocity));
  }
  [[nodiscard]] Estimate<Number> after_end() const {
    return estimate(signs::on_edge(from_next, edge, velocity), bounds::kOnEdge * (all() * m_velocity));
  }
  [[nodiscard]] Estimate<Number> starts_past() const {
    return estimate(signs::on_way(to_center, edge, velocity), bounds::kOnWay * (all() * m_edge));
  }
  [[nodiscard]] Estimate<Number> ends_past() const {
    return estimate(signs::on_way(to_end, edge, velocity), bounds::kOnWay * (all() * m_edge));
  }
  [[nodiscard]] Estimate<Number> out() const {
    return estimate(signs::lines(to_center, edge, velocity, radius), bounds::kLines * all() * all());
  }
};

/// Sees the vertices and edges that doubles leave open.
class CapsuleInDoubles {
 public:
  /// Requires round to nearest.
  CapsuleInDoubles(const MotionTriangleView& view, const CapsuleSigns& signs)
      : view_(view), signs_(signs), velocity_(exact_difference(view.motion + 4, view.motion)) {}

  [[nodiscard]] FilterResult vertex(int i) const {
    return is_vertex_hit(CapsuleVertex<DoubleDouble, double>{from(i), from_end(i), velocity_, view_.radius(),
                                                             signs_.center[i] * signs_.velocity});
  }
  [[nodiscard]] FilterResult edge(int i) const {
    const int next = i == 2 ? 0 : i + 1;
    const Vector3<DoubleDouble> edge = exact_difference(view_.vertex[next], view_.vertex[i]);
    if (is_zero(edge)) return FilterResult::No;  // it has no interior
    return is_edge_hit(CapsuleEdge<DoubleDouble, double>{from(i), from(next), from_end(i), edge, velocity_,
                                                         view_.radius(), signs_.center[i], signs_.edge[i],
                                                         signs_.velocity});
  }

 private:
  [[nodiscard]] Vector3<DoubleDouble> from(int i) const { return exact_difference(view_.motion, view_.vertex[i]); }
  [[nodiscard]] Vector3<DoubleDouble> from_end(int i) const {
    return exact_difference(view_.motion + 4, view_.vertex[i]);
  }

  const MotionTriangleView& view_;
  const CapsuleSigns& signs_;
  const Vector3<DoubleDouble> velocity_;
};

/// Returns whether the capsule touches a feature that is open. `capsule`: what is known of each vertex and edge.
template <class Capsule>
FilterResult open_features_hit(const CapsuleSigns& signs, const Capsule& capsule) {
  bool unsure = signs.may_pierce, touches = false;
  const auto consider = [&](FilterResult result) {
    touches = result == FilterResult::Yes;
    unsure = unsure || result == FilterResult::Unsure;
  };
  for (unsigned edges = signs.edges; edges != 0 && !touches; edges &= edges - 1)
    consider(capsule.edge(std::countr_zero(edges)));
  for (unsigned vertices = signs.vertices; vertices != 0 && !touches; vertices &= vertices - 1)
    consider(capsule.vertex(std::countr_zero(vertices)));
  return touches ? FilterResult::Yes : unsure ? FilterResult::Unsure : FilterResult::No;
}

/// Returns whether the capsule touches the triangle, if double-doubles can decide it. Requires round to nearest.
template <class Counts>
FilterResult unsure_capsule(const MotionTriangleView& view, const CapsuleSigns& signs, Counts& counts) {
  const double end[] = {view.to(0), view.to(1), view.to(2), view.radius()};
  if (signs.at_start != FilterResult::No && contact(BallTriangleView{view.vertex, view.motion}, counts))
    return FilterResult::Yes;
  if (signs.at_end != FilterResult::No && contact(BallTriangleView{view.vertex, end}, counts)) return FilterResult::Yes;
  const FilterResult result = open_features_hit(signs, CapsuleInDoubles(view, signs));
  if (result != FilterResult::Unsure) counts.count(Stage::DoubleDouble);
  return result;
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/signs/bounds.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"

/// The first stage for a ball and a triangle: all signs in doubles, one edge per lane, without branches.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// What decides is written once, over lanes `P` of any numbers: of doubles, and of numbers that record their operations
// for the proofs (robust/proofs).

/// The certain signs of one expression, as sign bits of the lanes.
template <class P>
struct LaneSigns {
  P positive, negative;
};

/// Returns the certain signs of a value with error `constant` kUnit (product of maxima). Maxima are so large that kTiny
/// need not be added.
template <class P>
TOUCHSTONE_INLINE LaneSigns<P> certain_signs(const P& value, double constant, const P& maxima) {
  const P factor = P::all(constant * bounds::kUnit);
  return {multiply_subtract(factor, maxima, value), multiply_add(factor, maxima, value)};
}

/// Returns a maximum that is at least kSmallest. Maxima may be larger than necessary, and from kSmallest on every bound
/// is above kTiny, which need not be added.
template <class P>
TOUCHSTONE_INLINE P not_too_small(const P& largest) {
  return maximum(largest, P::all(bounds::kSmallest));
}

// Vectors of lanes are copied by component: g++ 12 copies a whole one through memory in pieces, which costs more than
// the arithmetic.

/// A triangle as seen from its corners, one corner and the edge from it a lane; lane 3 repeats a corner.
template <class P>
struct TriangleLanes {
  Vector3<P> edge, normal;
  P m_edge, m_normal;  ///< maxima

  TOUCHSTONE_INLINE TriangleLanes(const Vector3<P>& edges, const Vector3<P>& normals)
      : edge{edges.x, edges.y, edges.z},
        normal{normals.x, normals.y, normals.z},
        m_edge(not_too_small(largest_component(edges))) {
    const P m_edges = m_edge * previous_of_three(m_edge);
    m_normal = m_edges + m_edges;
  }
};

/// Returns the vector that each lane's successor holds.
template <class P>
TOUCHSTONE_INLINE Vector3<P> next_of_three(const Vector3<P>& v) {
  return {next_of_three(v.x), next_of_three(v.y), next_of_three(v.z)};
}

/// Returns the triangle with these vertices.
template <class P>
TOUCHSTONE_INLINE TriangleLanes<P> triangle_lanes(const Vector3<P>& vertex) {
  const Vector3<P> previous{previous_of_three(vertex.x), previous_of_three(vertex.y), previous_of_three(vertex.z)};
  const Vector3<P> edge = difference(next_of_three(vertex), vertex);
  return {edge, signs::normal(edge, difference(previous, vertex))};
}

/// Loads three vertices.
TOUCHSTONE_INLINE Vector3<Pack> vertex_lanes(const double (*vertex)[3]) {
  Vector3<Pack> lanes;
  load_three_points(vertex[0], lanes.x, lanes.y, lanes.z);
  return lanes;
}
/// Returns one point in all lanes.
TOUCHSTONE_INLINE Vector3<Pack> point_lanes(const double* point) {
  return {all_lanes(point[0]), all_lanes(point[1]), all_lanes(point[2])};
}

/// A ball as seen from a triangle's corners and edges, with every sign of signs.h that matters for contact.
///
/// If `scaled`, every vector is in a unit of its own: the radius of a lane in that of `to_center`, the normal in those
/// of the edges before and after the lane's vertex.
template <class P, bool scaled = false>
struct BallAtTriangle {
  Vector3<P> to_center;
  P m_center;  ///< maximum
  LaneSigns<P> vertex_out, after_start, after_end, line_out, side_in, plane_out;

  TOUCHSTONE_INLINE BallAtTriangle(const TriangleLanes<P>& triangle, const Vector3<P>& from_corners, const P& radius)
      : to_center{from_corners.x, from_corners.y, from_corners.z},
        m_center(not_too_small(maximum(largest_component(from_corners), radius))) {
    const auto& [edge, normal, m_edge, m_normal] = triangle;
    const P m_both = m_center * m_edge, m_plane = m_normal * m_center;
    vertex_out = certain_signs(signs::vertex(to_center, radius), bounds::kVertex, m_center * m_center);
    after_start = certain_signs(signs::along(to_center, edge), bounds::kAlong, m_both);
    if constexpr (scaled)  // as seen from the end of the edge, all terms have the same units
      after_end =
          certain_signs(signs::along(next_of_three(to_center), edge), bounds::kAlong, next_of_three(m_center) * m_edge);
    else
      after_end = certain_signs(signs::beyond(to_center, edge), bounds::kBeyond, maximum(m_both, m_edge * m_edge));
    line_out = certain_signs(signs::line(to_center, edge, radius), bounds::kLine, m_both * m_both);
    side_in = certain_signs(signs::side(normal, edge, to_center), bounds::kSide, m_normal * m_both);
    plane_out = certain_signs(signs::plane(normal, to_center, radius), bounds::kPlane, m_plane * m_plane);
  }

  static constexpr unsigned all = 0b111;
  static TOUCHSTONE_INLINE unsigned lanes(const P& signs_of) { return negative_lanes(signs_of) & all; }

  /// Returns the lanes of edges that the ball certainly touches, and of those that it certainly misses.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned edges_touched() const {
    return lanes(vertex_out.negative | (line_out.negative & after_start.positive & after_end.negative));
  }
  [[nodiscard]] TOUCHSTONE_INLINE unsigned edges_missed() const {
    return lanes(vertex_out.positive & (line_out.positive | after_start.negative | after_end.positive));
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool certainly_touches() const {
    const unsigned touched = edges_touched(), inside = lanes(side_in.positive), cut = lanes(plane_out.negative);
    return (touched != 0) | ((inside == all) & (cut != 0));
  }
  [[nodiscard]] TOUCHSTONE_INLINE bool certainly_misses() const {
    const unsigned plane = lanes(plane_out.positive), outside = lanes(side_in.negative), missed = edges_missed();
    return (plane != 0) | ((outside != 0) & (missed == all));
  }
  /// Returns the bit of the sign on which alone contact depends, or 0. Requires that contact is not certain: then the
  /// plane is neither missed nor, by a foot inside, cut, and no edge is touched.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned lone_sign() const {
    const unsigned inside = lanes(side_in.positive), outside = lanes(side_in.negative);
    const unsigned vertices = all ^ lanes(vertex_out.positive);
    const unsigned lines = all ^ lanes(line_out.positive | after_start.negative | after_end.positive);
    // A line counts alone only if the foot on it is certainly between its ends.
    const unsigned unbounded = lines & ~lanes(after_start.positive & after_end.negative);
    const unsigned open = vertices << LoneSign::kVertices | lines << LoneSign::kLines | unbounded << LoneSign::kNone;
    const bool is_alone = ((open & (open - 1)) == 0) & (outside != 0);  // without a branch
    return inside == all ? 1U << LoneSign::kPlane : is_alone ? open : 0;
  }
};

/// Returns whether ball and triangle are small enough for these lanes. If coordinates are at most half the limit,
/// differences are within it and do not overflow.
TOUCHSTONE_INLINE bool in_range(const Vector3<Pack>& vertex, const double* ball) {
  const Pack input = maximum(largest_component(vertex), magnitude(load(ball)));
  return negative_lanes(all_lanes(bounds::kLargest / 2) - input) == 0;
}

/// Writes all signs.
template <bool scaled>
TOUCHSTONE_INLINE void write(TriangleSigns& signs, const TriangleLanes<Pack>& triangle,
                             const BallAtTriangle<Pack, scaled>& ball) {
  const auto both = [](const LaneSigns<Pack>& s) {
    return CertainSigns{BallAtTriangle<Pack>::lanes(s.positive), BallAtTriangle<Pack>::lanes(s.negative)};
  };
  signs.vertex = both(ball.vertex_out), signs.line = both(ball.line_out);
  signs.along = both(ball.after_start), signs.beyond = both(ball.after_end);
  signs.side = both(ball.side_in), signs.plane = both(ball.plane_out);
  signs.reachable = ball.edges_missed() ^ BallAtTriangle<Pack>::all;
  store(signs.to_center, ball.m_center);
  store(signs.edge, triangle.m_edge);
}
/// Writes the lone sign, if doubles cannot decide contact.
TOUCHSTONE_INLINE void write(LoneSign& sign, const TriangleLanes<Pack>& triangle, const BallAtTriangle<Pack>& ball) {
  sign.bit = ball.lone_sign();
  store(sign.to_center, ball.m_center);
  store(sign.edge, triangle.m_edge);
}

/// Returns whether the ball touches the triangle, if doubles can decide it. Writes `signs` if they cannot, or always if
/// `always`.
template <bool always, class Signs, bool scaled>
TOUCHSTONE_INLINE FilterResult filter_edges(const TriangleLanes<Pack>& triangle,
                                            const BallAtTriangle<Pack, scaled>& ball, Signs& signs) {
  const bool yes = ball.certainly_touches(), no = ball.certainly_misses();
  // Never both. g++ compiles `yes | no` to two branches, the first of which depends on the data and is mispredicted. It
  // compiles `yes ? Yes : No` to such a branch, too: that took a quarter of a query's time.
  static_assert(static_cast<FilterResult>(true) == FilterResult::Yes);
  if (!always && yes != no) [[likely]]
    return static_cast<FilterResult>(yes);
  write(signs, triangle, ball);
  return yes ? FilterResult::Yes : no ? FilterResult::No : FilterResult::Unsure;
}

/// Returns whether the ball touches the triangle, if doubles can decide it. Writes `signs`, a TriangleSigns or a
/// LoneSign, if they cannot, or always if `always`; never if the result is OutOfRange.
///
/// Valid in every rounding direction and under flush-to-zero. Raises no flags except INEXACT and UNDERFLOW.
template <bool always = false, class Signs>
TOUCHSTONE_INLINE FilterResult triangle_filter(const BallTriangleView& view, Signs& signs) {
  const Vector3<Pack> vertex = vertex_lanes(view.vertex);
  if (!in_range(vertex, view.center)) [[unlikely]]
    return FilterResult::OutOfRange;
  const TriangleLanes<Pack> triangle = triangle_lanes(vertex);
  const BallAtTriangle<Pack> ball(triangle, difference(point_lanes(view.center), vertex), all_lanes(view.radius()));
  return filter_edges<always>(triangle, ball, signs);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

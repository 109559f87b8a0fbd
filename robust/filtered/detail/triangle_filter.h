// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/ball_triangle_view.h"
#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/numbers/pack.h"
#include "robust/filtered/detail/signs.h"

/// The first stage for a ball and a triangle: all signs in doubles, one edge per lane, without branches.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Vectors of a ball and a triangle as seen from its vertices, one edge a lane.
struct EdgeLanes {
  Vector3<Pack> to_center, edge, normal;
  Pack radius;
};

/// Returns whether the ball touches the triangle, if doubles can decide it. Writes `signs` if they cannot, or always if
/// `always`. With `scaled`, every vector is in a unit of its own: the radius of a lane in that of `to_center`, the
/// normal in those of the edges before and after the lane's vertex.
template <bool always, bool scaled>
TOUCHSTONE_INLINE FilterResult filter_edges(const EdgeLanes& seen, TriangleSigns& signs) {
  const Vector3<Pack>&to_center = seen.to_center, &edge = seen.edge, &normal = seen.normal;
  const Pack& radius = seen.radius;
  const auto largest = [](const Vector3<Pack>& v) {
    return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  };

  // Maxima may be larger than necessary. From kSmallest on every bound is above kTiny, which need not be added.
  const Pack smallest = all_lanes(bounds::kSmallest);
  const Pack m_center = maximum(largest(to_center), maximum(radius, smallest)),
             m_edge = maximum(largest(edge), smallest);
  const Pack m_edges = m_edge * previous_of_three(m_edge), m_normal = m_edges + m_edges, m_both = m_center * m_edge;
  struct Signs {
    Pack positive, negative;  // as sign bits
  };
  const auto certain = [](const Pack& value, double constant, const Pack& maxima) {
    const Pack factor = all_lanes(constant * bounds::kUnit);
    return Signs{multiply_subtract(factor, maxima, value), multiply_add(factor, maxima, value)};
  };
  const Signs vertex_out = certain(signs::vertex(to_center, radius), bounds::kVertex, m_center * m_center);
  const Signs after_start = certain(signs::along(to_center, edge), bounds::kAlong, m_both);
  const Signs after_end = [&] {
    if constexpr (!scaled)
      return certain(signs::beyond(to_center, edge), bounds::kBeyond, maximum(m_both, m_edge * m_edge));
    // As seen from the end of the edge, all terms have the same units.
    const Vector3<Pack> from_end{next_of_three(to_center.x), next_of_three(to_center.y), next_of_three(to_center.z)};
    return certain(signs::along(from_end, edge), bounds::kAlong, next_of_three(m_center) * m_edge);
  }();
  const Signs line_out = certain(signs::line(to_center, edge, radius), bounds::kLine, m_both * m_both);
  const Signs side_in = certain(signs::side(normal, edge, to_center), bounds::kSide, m_normal * m_both);
  const Pack m_plane = m_normal * m_center;
  const Signs plane_out = certain(signs::plane(normal, to_center, radius), bounds::kPlane, m_plane * m_plane);

  constexpr unsigned all = 0b111;
  const Pack edge_in = vertex_out.negative | (line_out.negative & after_start.positive & after_end.negative);
  const Pack edge_out = vertex_out.positive & (line_out.positive | after_start.negative | after_end.positive);
  const auto lanes = [](const Pack& signs_of) { return negative_lanes(signs_of) & all; };
  const unsigned inside = lanes(side_in.positive), outside = lanes(side_in.negative);
  const unsigned missed = lanes(plane_out.positive), cut = lanes(plane_out.negative);
  const bool yes = (lanes(edge_in) != 0) | ((inside == all) & (cut != 0));
  const unsigned out = lanes(edge_out);
  const bool no = (missed != 0) | ((outside != 0) & (out == all));
  // Never both. g++ compiles `yes | no` to two branches, the first of which depends on the data and is mispredicted.
  if (!always && yes != no) [[likely]]
    return yes ? FilterResult::Yes : FilterResult::No;
  const auto both = [&](const Signs& s) { return CertainSigns{lanes(s.positive), lanes(s.negative)}; };
  signs.vertex = both(vertex_out), signs.line = both(line_out);
  signs.along = both(after_start), signs.beyond = both(after_end);
  signs.side = {inside, outside}, signs.plane = {missed, cut};
  signs.reachable = out ^ all;
  store(signs.to_center, m_center);
  store(signs.edge, m_edge);
  return yes ? FilterResult::Yes : no ? FilterResult::No : FilterResult::Unsure;
}

/// Returns whether the ball touches the triangle, if doubles can decide it. Writes `signs` if they cannot, or always if
/// `always`; never if the result is OutOfRange.
///
/// Valid in every rounding direction and under flush-to-zero. Raises no flags except INEXACT and UNDERFLOW.
template <bool always = false>
TOUCHSTONE_INLINE FilterResult triangle_filter(const BallTriangleView& view, TriangleSigns& signs) {
  Vector3<Pack> vertex;
  load_three_points(view.vertex[0], vertex.x, vertex.y, vertex.z);
  const Vector3<Pack> center{all_lanes(view.center[0]), all_lanes(view.center[1]), all_lanes(view.center[2])};
  const Pack radius = all_lanes(view.radius());

  const auto largest = [](const Vector3<Pack>& v) {
    return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  };
  // If coordinates are at most half the limit, differences are within it and do not overflow.
  const Pack input = maximum(largest(vertex), magnitude(load(view.center)));
  if (negative_lanes(all_lanes(bounds::kLargest / 2) - input) != 0) [[unlikely]]
    return FilterResult::OutOfRange;

  const Vector3<Pack> next{next_of_three(vertex.x), next_of_three(vertex.y), next_of_three(vertex.z)};
  const Vector3<Pack> previous{previous_of_three(vertex.x), previous_of_three(vertex.y), previous_of_three(vertex.z)};
  const auto difference = [](const Vector3<Pack>& a, const Vector3<Pack>& b) {
    return Vector3<Pack>{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const Vector3<Pack> edge = difference(next, vertex);
  return filter_edges<always, false>(
      {difference(center, vertex), edge, signs::normal(edge, difference(previous, vertex)), radius}, signs);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/detail/ball_triangle_view.h"
#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/numbers/pack.h"
#include "robust/filtered/detail/signs.h"

/// The first stage for a ball and a triangle: all signs in doubles, an edge a lane, without a branch.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Does the ball touch the triangle, if doubles can tell? `signs` is written where they cannot, or always, but never
/// where the answer is Beyond.
///
/// Holds in every rounding direction and under flush-to-zero. No flag but INEXACT and UNDERFLOW is raised.
template <bool always = false>
TOUCHSTONE_INLINE Sure triangle_filter(const TriangleQuestion& question, TriangleSigns& signs) {
  Vector3<Pack> vertex;
  load_three_points(question.vertex[0], vertex.x, vertex.y, vertex.z);
  const Vector3<Pack> center{all_lanes(question.center[0]), all_lanes(question.center[1]),
                             all_lanes(question.center[2])};
  const Pack radius = all_lanes(question.radius());

  const auto largest = [](const Vector3<Pack>& v) {
    return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  };
  // With coordinates of half the limit no difference is beyond it, and none overflows.
  const Pack input = maximum(largest(vertex), magnitude(load(question.center)));
  if (negative_lanes(all_lanes(bounds::kLargest / 2) - input) != 0) [[unlikely]]
    return Sure::Beyond;

  const Vector3<Pack> next{next_of_three(vertex.x), next_of_three(vertex.y), next_of_three(vertex.z)};
  const Vector3<Pack> previous{previous_of_three(vertex.x), previous_of_three(vertex.y), previous_of_three(vertex.z)};
  const auto difference = [](const Vector3<Pack>& a, const Vector3<Pack>& b) {
    return Vector3<Pack>{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const Vector3<Pack> from = difference(center, vertex), edge = difference(next, vertex);
  const Vector3<Pack> normal = signs::normal(edge, difference(previous, vertex));

  // Maxima may be taken larger than they are: from kSmallest on every bound is above kTiny, which need not be added.
  const Pack smallest = all_lanes(bounds::kSmallest);
  const Pack m_from = maximum(largest(from), maximum(radius, smallest)), m_edge = maximum(largest(edge), smallest);
  const Pack m_edges = m_edge * previous_of_three(m_edge), m_normal = m_edges + m_edges, m_both = m_from * m_edge;
  struct Signs {
    Pack positive, negative;  // as sign bits
  };
  const auto sure = [](const Pack& value, double constant, const Pack& maxima) {
    const Pack factor = all_lanes(constant * bounds::kUnit);
    return Signs{multiply_subtract(factor, maxima, value), multiply_add(factor, maxima, value)};
  };
  const Signs vertex_out = sure(signs::vertex(from, radius), bounds::kVertex, m_from * m_from);
  const Signs after_start = sure(signs::along(from, edge), bounds::kAlong, m_both);
  const Signs after_end = sure(signs::beyond(from, edge), bounds::kBeyond, maximum(m_both, m_edge * m_edge));
  const Signs line_out = sure(signs::line(from, edge, radius), bounds::kLine, m_both * m_both);
  const Signs side_in = sure(signs::side(normal, edge, from), bounds::kSide, m_normal * m_both);
  const Pack m_plane = m_normal * m_from;
  const Signs plane_out = sure(signs::plane(normal, from, radius), bounds::kPlane, m_plane * m_plane);

  constexpr unsigned all = 0b111;
  const Pack edge_in = vertex_out.negative | (line_out.negative & after_start.positive & after_end.negative);
  const Pack edge_out = vertex_out.positive & (line_out.positive | after_start.negative | after_end.positive);
  const auto lanes = [](const Pack& signs_of) { return negative_lanes(signs_of) & all; };
  const unsigned inside = lanes(side_in.positive), outside = lanes(side_in.negative);
  const unsigned missed = lanes(plane_out.positive), cut = lanes(plane_out.negative);
  const bool yes = (lanes(edge_in) != 0) | ((inside == all) & (cut != 0));
  const unsigned out = lanes(edge_out);
  const bool no = (missed != 0) | ((outside != 0) & (out == all));
  // Never both. Of `yes | no` g++ makes two branches, and the first one goes as the data do.
  if (!always && yes != no) [[likely]]
    return yes ? Sure::Yes : Sure::No;
  const auto both = [&](const Signs& s) { return SureSigns{lanes(s.positive), lanes(s.negative)}; };
  signs.vertex = both(vertex_out), signs.line = both(line_out);
  signs.along = both(after_start), signs.beyond = both(after_end);
  signs.side = {inside, outside}, signs.plane = {missed, cut};
  signs.reachable = out ^ all;
  store(signs.from, m_from);
  store(signs.edge, m_edge);
  return yes ? Sure::Yes : no ? Sure::No : Sure::Unsure;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

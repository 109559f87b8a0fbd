// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "robust/filtered/bounds.h"
#include "robust/filtered/numbers/pack.h"
#include "robust/filtered/signs.h"

/// The first stage for a ball and a triangle: all signs in doubles, an edge a lane, without a branch.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// What is sure of one sign in each lane, a bit a lane; where neither bit is set, doubles cannot tell.
struct SureSigns {
  unsigned positive, negative;
};

/// Every sign of signs.h that bears on a contact, lane i for edge i (lane 3 repeats edge 0). The plane's is one sign,
/// seen from three edges.
struct TriangleSigns {
  SureSigns vertex, along, beyond, line, side, plane;
};

enum class Sure : unsigned char { No, Yes, Unsure };

/// A triangle and a ball as plain numbers: vertices, centre, radius.
struct TriangleQuestion {
  double vertex[3][3];
  double center[3];
  double radius;
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

/// Does the ball touch the triangle, if doubles can tell? `signs` is written where they cannot.
///
/// Holds in every rounding direction and under flush-to-zero. No flag but INEXACT and UNDERFLOW is raised.
TOUCHSTONE_INLINE Sure triangle_filter(const TriangleQuestion& question, TriangleSigns& signs) {
  const auto& p = question.vertex;
  const Vector3<Pack> vertex{Pack{p[0][0], p[1][0], p[2][0], p[0][0]}, Pack{p[0][1], p[1][1], p[2][1], p[0][1]},
                             Pack{p[0][2], p[1][2], p[2][2], p[0][2]}};
  const Vector3<Pack> center{all_lanes(question.center[0]), all_lanes(question.center[1]),
                             all_lanes(question.center[2])};
  const Pack radius = all_lanes(question.radius);

  const auto largest = [](const Vector3<Pack>& v) {
    return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  };
  // Half the largest maximum for each coordinate: then no difference is beyond it.
  const Pack input = maximum(maximum(largest(vertex), largest(center)), radius);
  if (lanes(input <= all_lanes(bounds::kLargest / 2)) != 15) {
    signs = {};
    return Sure::Unsure;
  }

  const auto next = [](const Pack& a) { return __builtin_shufflevector(a, a, 1, 2, 0, 1); };
  const auto next_vector = [&next](const Vector3<Pack>& v) { return Vector3<Pack>{next(v.x), next(v.y), next(v.z)}; };
  const auto difference = [](const Vector3<Pack>& a, const Vector3<Pack>& b) {
    return Vector3<Pack>{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  const Vector3<Pack> from = difference(center, vertex), edge = difference(next_vector(vertex), vertex);
  const Vector3<Pack> next_from = next_vector(from), next_edge = next_vector(edge);
  const Vector3<Pack> normal = signs::normal(edge, next_edge);

  const Pack m_from = maximum(largest(from), radius), m_edge = largest(edge);
  const Pack m_normal = 2 * (m_edge * next(m_edge));
  const auto sure = [](const Pack& value, double constant, const Pack& maxima) {
    const Pack bound = (constant * bounds::kUnit) * maxima + bounds::kTiny;
    return std::pair<Mask, Mask>{value > bound, value < -bound};
  };
  const auto [vertex_out, vertex_in] = sure(signs::vertex(from, radius), bounds::kVertex, m_from * m_from);
  const auto [after_start, before_start] = sure(signs::along(from, edge), bounds::kAlong, m_from * m_edge);
  const auto [after_end, before_end] = sure(signs::along(next_from, edge), bounds::kAlong, next(m_from) * m_edge);
  const auto [line_out, line_in] = sure(signs::line(from, edge, radius), bounds::kLine, m_from * m_from * m_edge * m_edge);
  const auto [side_in, side_out] = sure(signs::side(normal, edge, from), bounds::kSide, m_normal * m_edge * m_from);
  const auto [plane_out, plane_in] =
      sure(signs::plane(normal, from, radius), bounds::kPlane, m_normal * m_normal * m_from * m_from);

  const Mask edge_in = vertex_in | (line_in & after_start & before_end);
  const Mask edge_out = vertex_out & (line_out | before_start | after_end);
  const unsigned plane_out_lanes = lanes(plane_out), side_out_lanes = lanes(side_out);
  const bool yes = lanes(edge_in) != 0 || (lanes(side_in) == 15 && lanes(plane_in) != 0);
  const bool no = plane_out_lanes != 0 || (side_out_lanes != 0 && lanes(edge_out) == 15);
  if (yes | no) [[likely]] return yes ? Sure::Yes : Sure::No;
  signs = {{lanes(vertex_out), lanes(vertex_in)},     {lanes(after_start), lanes(before_start)},
           {lanes(after_end), lanes(before_end)},     {lanes(line_out), lanes(line_in)},
           {lanes(side_in), side_out_lanes},          {plane_out_lanes, lanes(plane_in)}};
  return Sure::Unsure;
}

#pragma GCC diagnostic pop

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

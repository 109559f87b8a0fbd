// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/validate.h"

#include <string>

#include "geometry/detail/floating_point_state.h"
#include "robust/exact/detail/edge_sweep.h"

namespace touchstone::exact {

using namespace detail;

namespace {

std::string edge_name(const Polygon& polygon, std::size_t i) {
  return "edge " + std::to_string(i) + " (vertices " + std::to_string(i) + ", " + std::to_string(polygon.next(i)) + ")";
}

/// Returns `edge 2 (vertices 2, 3) meets edge 5 (vertices 5, 0)`, or says that an edge becomes a point.
std::string meeting(const Polygon& polygon, const Meeting& edges) {
  if (edges.first == edges.second)
    return edge_name(polygon, edges.first) + " becomes a point when the polygon is projected along its dropped axis";
  return edge_name(polygon, edges.first) + " meets " + edge_name(polygon, edges.second);
}

}  // namespace

std::optional<Rejection> validate(const Polygon& polygon) {
  const FloatingPointState nearest;
  const std::optional<int> axis = dropped_axis(polygon);
  if (!axis) return Rejection{RejectionCode::ZeroNormal, "the outer loop: its Newell normal is zero"};
  const PlanarLoops loops(polygon, *axis);

  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop)
    if (const auto found = find_meeting(loops, polygon.loop_begin(loop), polygon.loop_end(loop)))
      return Rejection{RejectionCode::LoopMeetsItself, loop_name(loop) + ": " + meeting(polygon, *found)};

  if (polygon.loop_count() == 1) return std::nullopt;
  if (const auto found = find_meeting(loops, 0, polygon.vertex_count()))
    return Rejection{RejectionCode::LoopsMeet, loop_name(polygon.loop_of(found->first)) + " and " +
                                                   loop_name(polygon.loop_of(found->second)) + ": " +
                                                   meeting(polygon, *found)};

  for (std::size_t loop = 1; loop < polygon.loop_count(); ++loop)
    if (!is_inside(loops, polygon.loop_begin(loop), 0, polygon.loop_end(0)))
      return Rejection{
          RejectionCode::HoleOutside,
          loop_name(loop) + ": vertex " + std::to_string(polygon.loop_begin(loop)) + " is not inside the outer loop"};
  return std::nullopt;
}

}  // namespace touchstone::exact

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

/// Returns `edge 2 (vertices 2, 3) crosses edge 5 (vertices 5, 0)`, for example.
std::string sentence(const Polygon& polygon, const Meeting& edges) {
  const std::string first = edge_name(polygon, edges.first), second = edge_name(polygon, edges.second);
  switch (edges.kind) {
    case Meeting::Kind::Point: return first + " becomes a point when the polygon is projected along its dropped axis";
    case Meeting::Kind::Crossing: return first + " crosses " + second;
    case Meeting::Kind::Overlap: break;
  }
  return first + " overlaps " + second;
}

}  // namespace

std::optional<Rejection> validate(const Polygon& polygon) {
  const FloatingPointState nearest;
  const std::optional<int> axis = dropped_axis(polygon);
  if (!axis) return Rejection{RejectionCode::ZeroNormal, "the outer loop: its Newell normal is zero"};
  const PlanarLoops loops(polygon, *axis);

  for (std::size_t loop = 0; loop < polygon.loop_count(); ++loop)
    if (const auto found = find_meeting(loops, polygon.loop_begin(loop), polygon.loop_end(loop)))
      return Rejection{RejectionCode::LoopMeetsItself, loop_name(loop) + ": " + sentence(polygon, *found)};

  if (polygon.loop_count() == 1) return std::nullopt;
  if (const auto found = find_meeting(loops, 0, polygon.vertex_count()))
    return Rejection{RejectionCode::LoopsMeet, loop_name(polygon.loop_of(found->first)) + " and " +
                                                   loop_name(polygon.loop_of(found->second)) + ": " +
                                                   sentence(polygon, *found)};

  for (std::size_t loop = 1; loop < polygon.loop_count(); ++loop)
    if (const std::size_t edge = polygon.loop_begin(loop); !begins_inside(loops, edge, 0, polygon.loop_end(0)))
      return Rejection{RejectionCode::HoleOutside,
                       loop_name(loop) + ": " + edge_name(polygon, edge) + " lies outside the outer loop"};
  return std::nullopt;
}

}  // namespace touchstone::exact

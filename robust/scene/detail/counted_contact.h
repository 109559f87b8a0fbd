// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/bigint_sign.h"
#include "robust/filtered/detail/frame_query.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/motion/polygon_motion.h"
#include "robust/filtered/detail/prepared.h"
#include "robust/filtered/detail/sign_ladder.h"
#include "robust/filtered/detail/triangle_contact.h"
#include "robust/filtered/motion.h"
#include "robust/scene/detail/tally.h"

/// The contact query for one face, with its outcome. Only the walks that count use it.
namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

using filtered::BallTriangleView;
using filtered::SignKind;

/// Returns the exact sign for edge i of a triangle. Requires round to nearest, without flush-to-zero.
template <SignKind kind>
int sign(const BallTriangleView& view, int i) {
  using Vector = filtered::Vector3<filtered::DoubleDouble>;
  const auto bigint = [&] { return filtered::bigint_sign(kind, view, i); };
  if (filtered::largest_number(view) > filtered::bounds::kLargest / 2) return bigint();
  const auto difference = [](const double* a, const double* b) -> Vector {
    using filtered::two_difference;
    return {two_difference(a[0], b[0]), two_difference(a[1], b[1]), two_difference(a[2], b[2])};
  };
  const auto edge = [&](int k) { return difference(view.vertex[(k + 1) % 3], view.vertex[k]); };
  const auto largest = [](const Vector& v) {
    return std::max({std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)});
  };
  const Vector to_center = difference(view.center, view.vertex[i]), along = edge(i);
  const Vector normal_edges[] = {edge(0), edge(1)};
  const Vector normal = filtered::signs::normal(normal_edges[0], normal_edges[1]);
  const double longest = std::max({largest(edge(0)), largest(edge(1)), largest(edge(2))});
  const filtered::Maxima maxima{std::max(largest(to_center), view.radius()), longest, 2 * longest * longest};
  filtered::NoCounts counts;
  return filtered::exact_sign<kind>({to_center, along, normal, view.radius(), 0, maxima, false, normal_edges, false},
                                    counts, bigint);
}

/// Returns the outcome for a triangle that the ball does not touch.
inline CullOutcome outcome_of_missed(const BallTriangleView& view) {
  if (sign<SignKind::Plane>(view, 0) > 0) return CullOutcome::Slab;
  for (int i = 0; i < 3; ++i)
    if (sign<SignKind::Side>(view, i) < 0 && sign<SignKind::Line>(view, i) > 0) return CullOutcome::Foot;
  return CullOutcome::Edges;
}

inline bool foot_outside(const BallTriangleView& view) {
  for (int i = 0; i < 3; ++i)
    if (sign<SignKind::Side>(view, i) < 0) return true;
  return false;
}

inline bool touches(const Ball& ball, const Triangle& triangle, Tally& tally) {
  const BallTriangleView view = filtered::view_of(ball, triangle);
  filtered::StageCounts stages;
  const bool touched = filtered::contact(view, stages);
  const CullOutcome outcome = touched ? CullOutcome::Touched : outcome_of_missed(view);
  const bool by_edges = outcome == CullOutcome::Edges || (touched && foot_outside(view));
  tally.meet(outcome, stages.last(), by_edges ? 3 : 0);
  return touched;
}

/// Returns whether the moving ball stays on one side of the triangle's plane and does not reach it.
inline bool stays_off_plane(const Motion& motion, const Triangle& triangle) {
  const Ball end{motion.to, motion.ball.radius};
  const BallTriangleView first = filtered::view_of(motion.ball, triangle), last = filtered::view_of(end, triangle);
  return sign<SignKind::Plane>(first, 0) > 0 && sign<SignKind::Plane>(last, 0) > 0 &&
         sign<SignKind::Front>(first, 0) == sign<SignKind::Front>(last, 0);
}

inline bool touches(const Motion& motion, const Triangle& triangle, Tally& tally) {
  filtered::StageCounts stages;
  const bool touched = filtered::contact(motion, triangle, stages);
  const bool slab = !touched && stays_off_plane(motion, triangle);
  tally.meet(touched ? CullOutcome::Touched
             : slab  ? CullOutcome::Slab
                     : CullOutcome::Edges,
             stages.last(), slab ? 0 : 3);
  return touched;
}

/// Returns how many edges of the polygon filtered::contact examines, by repeating its walk.
inline std::size_t edges_looked_at(const Ball& ball, const filtered::PreparedPolygon::Parts& parts) {
  const double largest =
      std::max({std::abs(ball.center[0]), std::abs(ball.center[1]), std::abs(ball.center[2]), ball.radius});
  if (!parts.frame || largest > parts.frame->reachable) return parts.polygon.vertex_count();
  const filtered::HeightQuery height(ball, *parts.frame);
  if (height.plane_sign() > 0) return 0;
  const filtered::FrameQuery query(height, *parts.frame);
  const double limit_sq = filtered::larger(query.certain_miss_sq, query.boundary_sq);
  std::size_t edges = 0;
  const auto look = [&](const filtered::EdgeTree::Leaf& leaf, const filtered::LeafView& view) {
    edges += leaf.count;
    const unsigned hit = negative_lanes(view.squared - filtered::all_lanes(query.certain_hit_sq));
    return (hit & ((1U << leaf.count) - 1)) != 0;
  };
  (void)filtered::walk(*parts.edges, query, limit_sq, look);
  return edges;
}

inline bool touches(const Ball& ball, const filtered::PreparedPolygon& polygon, Tally& tally) {
  filtered::StageCounts stages;
  const bool touched = filtered::contact(ball, polygon, stages);
  const bool slab = !touched && filtered::plane_side(ball, polygon) != PlaneSide::Intersects;
  const std::size_t edges = edges_looked_at(ball, parts_of(polygon));
  const CullOutcome outcome = touched      ? CullOutcome::Touched
                              : slab       ? CullOutcome::Slab
                              : edges == 0 ? CullOutcome::Foot
                                           : CullOutcome::Edges;
  tally.meet(outcome, stages.last(), edges);
  return touched;
}

/// Returns how many edges of the polygon are near the plane's part that the moving ball may reach.
inline std::size_t edges_looked_at(const Motion& motion, const filtered::PreparedPolygon::Parts& parts) {
  const auto in_frame = filtered::frame_motion(motion, parts);
  if (!in_frame) return parts.polygon.vertex_count();
  std::size_t edges = 0;
  const auto look = [&](const filtered::EdgeTree::Leaf& leaf, unsigned) { edges += leaf.count; };
  filtered::walk(*parts.edges, filtered::SweptDisc(*in_frame), look);
  return edges;
}

inline bool touches(const Motion& motion, const filtered::PreparedPolygon& polygon, Tally& tally) {
  filtered::StageCounts stages;
  const bool touched = filtered::contact(motion, polygon, stages);
  const auto side = [&](const Eigen::Vector3d& center) {
    return filtered::plane_side({center, motion.ball.radius}, polygon);
  };
  const PlaneSide first = side(motion.ball.center);
  const bool slab = !touched && first != PlaneSide::Intersects && first == side(motion.to);
  tally.meet(touched ? CullOutcome::Touched
             : slab  ? CullOutcome::Slab
                     : CullOutcome::Edges,
             stages.last(), slab ? 0 : edges_looked_at(motion, parts_of(polygon)));
  return touched;
}

/// Returns false: walks that count continue after the answer is known, to count the remaining faces.
template <class Asked, class Face>
bool ends(const Asked& asked, const Face& face, Tally& tally) {
  if (tally.answered())
    tally.pass();
  else if (touches(asked, face, tally))
    tally.answer();
  return false;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene

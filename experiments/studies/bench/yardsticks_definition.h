// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "experiments/studies/bench/yardsticks.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"

namespace touchstone::bench {

inline namespace TOUCHSTONE_TARGET {

/// Writes what is known of a group as a whole, as filtered::detail::group_contact does before it asks floats.
/// Returns false if nothing is. Requires a ball that is in reach of groups.
inline bool decided_as_a_whole(const Ball& ball, const filtered::detail::TriangleGroup& group,
                               std::span<bool> touches) {
  double seen[4];
  if (!filtered::detail::see(ball, group, seen)) return false;
  const bool holds = filtered::detail::holds_group(seen, ball.radius, group);
  if (!holds && !filtered::detail::misses_group(seen)) return false;
  std::ranges::fill(touches, holds);
  return true;
}

inline void without_floats(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches) {
  using filtered::detail::TriangleGroup;
  const filtered::TriangleSet::Parts& parts = filtered::parts_of(set);
  const bool reaches = filtered::detail::in_reach_of_groups(ball);
  filtered::NoCounts counts;
  for (std::size_t first = 0; first < touches.size(); first += TriangleGroup::kWidth) {
    const std::span<bool> own = touches.subspan(first, std::min(TriangleGroup::kWidth, touches.size() - first));
    if (reaches && decided_as_a_whole(ball, parts.groups[first / TriangleGroup::kWidth], own)) continue;
    for (std::size_t i = 0; i < own.size(); ++i)
      own[i] = filtered::detail::contact(filtered::detail::view_of(ball, parts.triangles[first + i]), counts);
  }
}

/// Returns whether the ball touches the polygon, as certain_distance_sign does, but as if nothing were rounded.
inline bool tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon) {
  const filtered::PreparedPolygon::Parts& parts = parts_of(polygon);
  const filtered::detail::Frame& frame = *parts.frame;
  const filtered::detail::HeightQuery height(ball, frame);
  const double disc_sq = (height.radius - std::abs(height.height)) * (height.radius + std::abs(height.height));
  if (disc_sq < 0) return false;
  filtered::detail::FrameQuery foot;
  foot.x = filtered::detail::frame::coordinate(frame.x, height.to_center);
  foot.y = filtered::detail::frame::coordinate(frame.y, height.to_center);
  if (parts.edges->is_scanned()) {
    foot.certain_hit_sq = foot.boundary_sq = -1, foot.certain_miss_sq = disc_sq;
    const filtered::detail::EdgesAndFoot seen = scanned(foot, parts.edges->leaves());
    return seen.unsure | seen.inside;
  }
  bool hit = false;
  const bool inside = walk(*parts.edges, foot, disc_sq,
                           [&](const filtered::detail::EdgeTree::Leaf& leaf, const filtered::detail::LeafView& view) {
                             const unsigned lanes = (1U << leaf.count) - 1;
                             hit = (~negative_lanes(filtered::detail::all_lanes(disc_sq) - view.squared) & lanes) != 0;
                             return hit;
                           });
  return hit || inside;
}

}  // namespace TOUCHSTONE_TARGET

}  // namespace touchstone::bench

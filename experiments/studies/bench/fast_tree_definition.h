// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/polygon/prepared.h"

namespace touchstone::bench {
inline namespace TOUCHSTONE_TARGET {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "experiments/studies/bench/expansion.h"
#include "experiments/studies/bench/variants.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon/frame_query.h"
#include "robust/filtered/detail/polygon/prepared.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"

namespace touchstone::bench {

inline namespace TOUCHSTONE_TARGET {

using filtered::Stage;
using filtered::detail::FilterResult;
using filtered::detail::SignKind;

/// Counts nothing, and leaves stages out.
template <Stage... left_out>
struct Without : filtered::NoCounts {
  static constexpr bool uses(Stage stage) { return ((stage != left_out) && ...); }
};

template <Stage... left_out>
bool contact_without(const Ball& ball, const Triangle& triangle) {
  Without<left_out...> counts;
  return filtered::detail::contact(filtered::detail::view_of(ball, triangle), counts);
}

/// As after a first stage that knows no sign. Requires numbers in its range, and round to nearest.
inline bool contact_without_first(const Ball& ball, const Triangle& triangle) {
  const filtered::detail::BallTriangleView view = filtered::detail::view_of(ball, triangle);
  filtered::detail::TriangleSigns signs{};
  constexpr unsigned kAll = 0b111;
  signs.reachable = kAll;
  for (int i = 0; i < 3; ++i) {
    signs.to_center[i] = view.radius();
    signs.edge[i] = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double vertex = view.vertex[i][axis], next = view.vertex[i == 2 ? 0 : i + 1][axis];
      signs.to_center[i] = std::max(signs.to_center[i], std::abs(view.center[axis] - vertex));
      signs.edge[i] = std::max(signs.edge[i], std::abs(next - vertex));
    }
  }
  filtered::NoCounts counts;
  return filtered::detail::UnsureTriangle<filtered::NoCounts>(view, signs, counts).contact();
}

/// An edge and a ball in expansions.
struct ExpansionView {
  const filtered::detail::BallTriangleView& view;
  int i;

  using Vector = filtered::detail::Vector3<Expansion>;
  static Vector difference(const double* a, const double* b) {
    return {exact_difference(a[0], b[0]), exact_difference(a[1], b[1]), exact_difference(a[2], b[2])};
  }
  [[nodiscard]] Vector to_center() const { return difference(view.center, view.vertex[i]); }
  [[nodiscard]] Vector edge() const { return difference(view.vertex[(i + 1) % 3], view.vertex[i]); }
  [[nodiscard]] auto normal() const {
    return filtered::detail::signs::normal(difference(view.vertex[1], view.vertex[0]),
                                           difference(view.vertex[2], view.vertex[1]));
  }
  [[nodiscard]] Expansion radius() const { return Expansion(view.radius()); }
};

inline int expansion_sign(SignKind kind, const ExpansionView& view) {
  switch (kind) {
    case SignKind::Vertex: return sign(filtered::detail::expression<SignKind::Vertex>(view));
    case SignKind::Along: return sign(filtered::detail::expression<SignKind::Along>(view));
    case SignKind::Beyond: return sign(filtered::detail::expression<SignKind::Beyond>(view));
    case SignKind::Line: return sign(filtered::detail::expression<SignKind::Line>(view));
    case SignKind::Side: return sign(filtered::detail::expression<SignKind::Side>(view));
    default: return sign(filtered::detail::expression<SignKind::Plane>(view));
  }
}

/// The first stage, then expansions.
inline bool contact_by_expansions(const Ball& ball, const Triangle& triangle) {
  const filtered::detail::BallTriangleView view = filtered::detail::view_of(ball, triangle);
  filtered::detail::TriangleSigns signs;
  const FilterResult result = filtered::detail::triangle_filter(view, signs);
  if (result < FilterResult::Unsure) return result == FilterResult::Yes;
  return filtered::detail::contact_by(signs, [&view](SignKind kind, int i) { return expansion_sign(kind, {view, i}); });
}

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

inline const std::vector<Variant>& all_variants() {
  static const std::vector<Variant> list{
      {"all stages", contact_without<>},
      {"no double", contact_without_first},
      {"no permanent", contact_without<Stage::Permanent>},
      {"no double-double", contact_without<Stage::DoubleDouble>},
      {"no fixed-integer", contact_without<Stage::FixedInteger>},
      {"only unlimited", contact_without<Stage::Permanent, Stage::DoubleDouble, Stage::FixedInteger>},
      {"only expansions", contact_by_expansions},
      {"generated filter", generated_filter_contact}};
  return list;
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

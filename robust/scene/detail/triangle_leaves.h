// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/triangle_groups_contact.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/tree_walk.h"

/// The leaves of a set's tree: up to eight triangles, which floats decide together.
namespace touchstone::scene {
inline namespace TOUCHSTONE_TARGET {

/// Calls f(place) for each of these triangles of a leaf, one per bit.
template <class F>
TOUCHSTONE_INLINE void for_lanes(unsigned lanes, const Leaf& leaf, const F& f) {
  for (; lanes != 0; lanes &= lanes - 1) f(leaf.first + static_cast<std::uint32_t>(__builtin_ctz(lanes)));
}

/// Returns whether f(place) holds for one of them.
template <class F>
TOUCHSTONE_INLINE bool any_lane(unsigned lanes, const Leaf& leaf, const F& f) {
  for (; lanes != 0; lanes &= lanes - 1)
    if (f(leaf.first + static_cast<std::uint32_t>(__builtin_ctz(lanes)))) return true;
  return false;
}

/// The triangles of a leaf that a ball may touch, one per bit, and a radius at which it touches one of the leaf's
/// triangles; infinite if floats know none that is smaller than the ball's.
struct NearLanes {
  unsigned lanes;
  double radius;
};

class TriangleLeaves {
 public:
  explicit TriangleLeaves(const PlacedTriangles& placed) : groups_(placed.groups.data()) {}

  void prefetch_leaf(const Leaf& leaf) const { prefetch(groups_ + leaf.number, 1); }

  /// Returns the triangles that a ball with the radius `inner` certainly touches, and those that floats leave open; the
  /// concentric `ball`, which is not smaller, certainly misses the others.
  [[nodiscard]] TOUCHSTONE_INLINE filtered::GroupAnswers contact(const Ball& ball, double inner,
                                                                 const Leaf& leaf) const {
    filtered::NoCounts counts;
    if (!filtered::in_reach_of_groups(ball)) return {0, all(leaf)};
    return filtered::group_contact(ball, inner, groups_[leaf.number], all(leaf), counts);
  }

  /// Returns the triangles that the ball may touch, and a radius at which it surely touches one. The radius is that of
  /// a ball that `LaneDistances::touched` finds to touch it.
  [[nodiscard]] TOUCHSTONE_INLINE NearLanes near(const Ball& ball, const Leaf& leaf) const {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const filtered::TriangleGroup& group = groups_[leaf.number];
    double seen[4];
    if (!filtered::in_reach_of_groups(ball) || !filtered::see(ball, group, seen)) [[unlikely]]
      return {all(leaf), unknown};
    if (filtered::misses_group(seen)) return {0, unknown};
    const filtered::LaneDistances distances = filtered::lane_distances(group, seen);
    const unsigned lanes = all(leaf) & ~distances.missed(seen[3]);
    if (lanes == 0) return {0, unknown};
    float lengths[filtered::kFloatLanes];
    store(lengths, distances.most);
    float least = std::numeric_limits<float>::infinity();
    for (unsigned rest = lanes; rest != 0; rest &= rest - 1) least = std::min(least, lengths[__builtin_ctz(rest)]);
    constexpr double wide = 1 + 0x1p-20;
    const double radius =
        (static_cast<double>(least) / filtered::TriangleGroup::kSteps + distances.error) * wide / group.scale;
    const double seen_radius = radius * group.scale;
    if (!(seen_radius < seen[3]) || (distances.touched(seen_radius) & lanes) == 0) return {lanes, unknown};
    return {lanes & ~distances.missed(seen_radius), radius};
  }

 private:
  [[nodiscard]] static unsigned all(const Leaf& leaf) { return (1U << leaf.count) - 1; }

  const filtered::TriangleGroup* groups_;
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::scene

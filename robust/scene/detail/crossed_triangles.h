// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <span>
#include <utility>

#include "robust/filtered/detail/triangle/triangle_crossing.h"
#include "robust/scene/detail/asked_triangles.h"
#include "robust/scene/detail/triangle_leaves.h"

/// The triangles of a set that a ray along a coordinate axis crosses.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// The operations on a leaf's lanes, in steps, over any number type. The tests run the error calculus of robust/proofs
/// over them.
namespace crossings {

/// The point is moved into the box with these coordinates. No stored vertex reaches beyond half of them, so that a
/// point which is moved is outside every triangle before and after.
inline constexpr double kClamp = 0x1p16;
/// A turn that is larger has the sign of the exact one, and so has a height. Proved in
/// tests/robust/proofs/crossings_test.cpp.
inline constexpr double kTurn = 0x1.8p18, kHeight = 1;

/// Returns the turn from a vertex over the next one to the point, from which both are seen.
template <class T>
TOUCHSTONE_INLINE T turn(const T& u, const T& v, const T& next_u, const T& next_v) {
  return multiply_subtract(u, next_v, v * next_u);
}

}  // namespace crossings

/// How a ray crosses the triangles of a leaf, as floats know it, one bit per triangle. It does not cross the others.
struct LaneCrossings {
  unsigned left, right;  ///< crossed, and the corners turn to the left or to the right as seen against the axis
  unsigned unsure;
};

TOUCHSTONE_INLINE LaneCrossings lane_crossings(const filtered::detail::AxisRay& ray,
                                               const filtered::detail::TriangleGroup& group, unsigned lanes) {
  using filtered::detail::all_float_lanes, filtered::detail::FloatPack, filtered::detail::load;
  if (group.reach < 0) [[unlikely]]
    return {0, 0, lanes};
  const auto seen = [&](int axis) {
    constexpr double steps = filtered::detail::TriangleGroup::kSteps;
    const double place = (ray.point.center[axis] - group.origin[axis]) * group.scale * steps;
    return all_float_lanes(static_cast<float>(std::clamp(place, -crossings::kClamp, crossings::kClamp)));
  };
  const int axes[] = {ray.first(), ray.second(), ray.axis};
  FloatPack u[3], v[3], w[3];
  const FloatPack point_u = seen(axes[0]), point_v = seen(axes[1]), point_w = seen(axes[2]);
  for (int i = 0; i < 3; ++i) {
    u[i] = load(group.vertices[i][axes[0]]) - point_u;
    v[i] = load(group.vertices[i][axes[1]]) - point_v;
    w[i] = load(group.vertices[i][axes[2]]) - point_w;
  }
  const FloatPack a = crossings::turn(u[0], v[0], u[1], v[1]), b = crossings::turn(u[1], v[1], u[2], v[2]),
                  c = crossings::turn(u[2], v[2], u[0], v[0]);
  const FloatPack least = minimum(a, minimum(b, c)), most = maximum(a, maximum(b, c));
  const FloatPack turn = all_float_lanes(static_cast<float>(crossings::kTurn));
  const FloatPack height = all_float_lanes(static_cast<float>(crossings::kHeight));
  const unsigned left = negative_lanes(turn - least), right = negative_lanes(most + turn);
  const unsigned missed = negative_lanes(maximum(turn - most, least + turn));
  const FloatPack low = minimum(w[0], minimum(w[1], w[2])), high = maximum(w[0], maximum(w[1], w[2]));
  unsigned ahead = negative_lanes(height - low), behind = negative_lanes(high + height);
  if (!ray.up) std::swap(ahead, behind);
  lanes &= ~(missed | behind);
  return {lanes & left & ahead, lanes & right & ahead, lanes & ~((left | right) & ahead)};
}

/// Adds up how a ray crosses the triangles of a set.
class CrossedTriangles {
 public:
  CrossedTriangles(const PlacedTriangles& placed, const filtered::detail::AxisRay& ray)
      : groups_(placed.groups.data()), triangles_(placed.triangles), ray_(ray) {}

  void prefetch_leaf(const Leaf& leaf) const { prefetch(groups_ + leaf.number, 1); }

  /// Adds the triangles of these leaves. Returns true if the point is on one of them, where the sum ends.
  [[nodiscard]] TOUCHSTONE_INLINE bool add(std::span<const Leaf> leaves) {
    for (const Leaf& leaf : leaves) {
      const LaneCrossings known = lane_crossings(ray_, groups_[leaf.number], all_triangles(leaf));
      const int turned = std::popcount(known.left) - std::popcount(known.right);
      sum_ += ray_.up ? turned : -turned;
      if (any_lane(known.unsure, leaf, [&](std::uint32_t place) { return add(place); })) return true;
    }
    return false;
  }

  /// Returns how often the ray leaves through the triangles, less how often it enters.
  [[nodiscard]] int sum() const { return sum_; }

 private:
  [[nodiscard]] __attribute__((noinline)) bool add(std::uint32_t place) {
    const Triangle triangle = triangles_[place].copy();
    const filtered::detail::BallTriangleView view = filtered::detail::view_of(ray_.point, triangle);
    filtered::NoCounts counts;
    if (!misses_box(ray_.point, triangles_[place]) && filtered::detail::contact(view, counts)) return true;
    sum_ += filtered::detail::crossing(view, ray_);
    return false;
  }

  const filtered::detail::TriangleGroup* groups_;
  const TrianglesOfSharedVertices& triangles_;
  const filtered::detail::AxisRay& ray_;
  int sum_ = 0;
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

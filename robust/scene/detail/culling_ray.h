// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "robust/filtered/detail/triangle/triangle_crossing.h"
#include "robust/scene/detail/culling_ball.h"

/// Finds the boxes of a tree that a ray may meet.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

/// A ray along a coordinate axis in the units of a tree, to test it against boxes.
///
/// Culling is conservative: a box that the ray meets is never culled. Scaling keeps the order of numbers, no box
/// reaches beyond 2^40, and the signs of differences of floats are exact.
class CullingRay {
 public:
  /// Requires round to nearest, without flush-to-zero.
  CullingRay(const filtered::detail::AxisRay& ray, const BoxTree& tree) {
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double beyond = culling::kLargestFloat;
      const auto nearest = static_cast<float>(std::clamp(scaled(ray.point.center[axis], tree), -beyond, beyond));
      const float apart = culling::apart(nearest);
      const bool along = axis == ray.axis;
      const auto far = static_cast<float>(beyond);
      first_[axis] = filtered::detail::all_float_lanes(along && !ray.up ? -far : nearest - apart);
      last_[axis] = filtered::detail::all_float_lanes(along && ray.up ? far : nearest + apart);
    }
  }

  /// Returns one bit for each child of a node whose box the ray may meet.
  [[nodiscard]] TOUCHSTONE_INLINE unsigned may_touch(const BoxTree::Node& node) const {
    return ~negative_lanes(minimum(met(node, 0), minimum(met(node, 1), met(node, 2)))) & all_children(node);
  }

 private:
  /// Returns a negative number for each child whose box is missed along an axis.
  [[nodiscard]] TOUCHSTONE_INLINE FloatPack met(const BoxTree::Node& node, int axis) const {
    const Sides box = sides(node, axis);
    return minimum(box.high - first_[axis], last_[axis] - box.low);
  }

  FloatPack first_[3], last_[3];  ///< between which the ray is
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

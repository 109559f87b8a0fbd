// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/shapes/motion.h"
#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/scene/detail/culling_motion.h"
#include "robust/scene/detail/shared_vertices.h"

/// The space that a moving ball sweeps. Requires round to nearest, without flush-to-zero.
namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET {

namespace swept {

/// By how much the radius of a shortened motion is larger: kMargin times the largest coordinate or radius, to cover the
/// roundings of the end and of the radius itself, and kTiny to cover underflow. Proved in
/// tests/robust/proofs/culling_motion_test.cpp.
inline constexpr double kMargin = 15 * 0x1p-53, kTiny = 0x1p-1073;

/// Returns the radius of a shortened motion, given the largest coordinate or radius.
template <class T>
TOUCHSTONE_INLINE T wider(const T& radius, const T& margin, const T& largest, const T& tiny) {
  return radius + margin * largest + tiny;
}

}  // namespace swept

/// The space that a moving ball sweeps until some time: its motion, and the box around it. Only ever too large.
class Swept {
 public:
  TOUCHSTONE_INLINE explicit Swept(const Motion& motion) : whole_(motion), motion_(motion) { set_box(); }

  /// Shortens the motion: it ends at this time. The end of the way is rounded; a larger radius makes up for that.
  TOUCHSTONE_INLINE void end_at(double time) {
    const Eigen::Vector3d &first = whole_.ball.center, &last = whole_.to, change = last - first;
    if (!(change.lpNorm<Eigen::Infinity>() <= std::numeric_limits<double>::max())) return;
    const double largest = std::max(first.lpNorm<Eigen::Infinity>(), last.lpNorm<Eigen::Infinity>());
    motion_.to = place_at(first, time, change);
    motion_.ball.radius =
        swept::wider(whole_.ball.radius, swept::kMargin, std::max(largest, whole_.ball.radius), swept::kTiny);
    set_box();
  }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  /// Returns whether the ball certainly misses the triangle's box along some axis. Culls most triangles of a leaf.
  [[nodiscard]] TOUCHSTONE_INLINE bool misses(const SharedTriangle& triangle) const {
    using filtered::detail::Pack;
    const Pack low = filtered::detail::load_three(low_), high = filtered::detail::load_three(high_);
    // A radius of -0 becomes +0: -0 - 0 and -0 + -0 have the sign of a miss.
    const Pack radius = filtered::detail::all_lanes(motion_.ball.radius + 0.0);
    const Pack a = filtered::detail::load_three(triangle.a.data()), b = filtered::detail::load_three(triangle.b.data()),
               c = filtered::detail::load_three(triangle.c.data());
    const Pack below = maximum(high - a, maximum(high - b, high - c)) + radius;
    const Pack above = radius - minimum(low - a, minimum(low - b, low - c));
    return (negative_lanes(below | above) & 0b111) != 0;
  }

 private:
  TOUCHSTONE_INLINE void set_box() {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(motion_.ball.center[axis], motion_.to[axis]);
      high_[axis] = std::max(motion_.ball.center[axis], motion_.to[axis]);
    }
  }

  Motion whole_;
  Motion motion_;  ///< the shortened one
  double low_[3], high_[3];
};

}  // namespace touchstone::scene::detail::inline TOUCHSTONE_TARGET

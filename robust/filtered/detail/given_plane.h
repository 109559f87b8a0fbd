// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "geometry/contact/answer.h"
#include "geometry/shapes/ball.h"
#include "robust/filtered/detail/bounds.h"
#include "robust/filtered/detail/frame.h"
#include "robust/filtered/detail/target.h"

/// The plane of a frame in the caller's unit of length, for balls that need not be scaled.
namespace touchstone::filtered {

/// Two doubles in one register.
using DoublePair = double __attribute__((vector_size(2 * sizeof(double))));

/// Scaling by a power of two changes nothing but what underflows, and bounds.h allows for that from Frame::kSubnormal
/// up. Up to kLargest, nothing overflows.
struct GivenPlane {
  static constexpr int kLargest = 900;  ///< of a frame's exponent

  double reach = -1;  ///< the limit for a ball's numbers; negative if there is no such plane
  double error = 0;   ///< of heights, less the part that grows with a ball's numbers
  double height = 0;  ///< of the plane above the origin
  DoublePair origin_xy{}, origin_z{}, normal_xy{}, normal_z{};  ///< the origin is vertex 0; second numbers of z are 0

  GivenPlane() = default;
  explicit GivenPlane(const Frame& frame);
};

inline namespace TOUCHSTONE_TARGET {

/// The height of a ball's centre above a given plane. Its bound grows with the distance from the origin of coordinates:
/// it costs less than that of HeightQuery, and decides less where a polygon is far from there. Valid as that is.
class GivenHeight {
 public:
  __attribute__((always_inline)) GivenHeight(const Ball& ball, const GivenPlane& plane) : ball_(ball), plane_(plane) {
    std::memcpy(&xy_, &ball.center[0], sizeof xy_);
    static_assert(sizeof(Ball) == 2 * sizeof(DoublePair), "the radius follows the centre");
    std::memcpy(&z_, &ball.center[2], sizeof z_);
    const DoublePair larger = larger_of(magnitude(xy_), magnitude(z_));
    widest_ = larger[0] > larger[1] ? larger[0] : larger[1];
  }
  /// Returns whether nothing overflows.
  [[nodiscard]] __attribute__((always_inline)) bool is_in_reach() const { return widest_ <= plane_.reach; }

  /// Sets the side of the plane, and returns whether it is certain. Requires a ball in reach.
  [[nodiscard]] __attribute__((always_inline)) bool find_side(PlaneSide& side) const {
    // As frame::height, except for the order of the sum, whose terms are bounded alike.
    const DoublePair sum = (xy_ - plane_.origin_xy) * plane_.normal_xy + (z_ - plane_.origin_z) * plane_.normal_z;
    const double height = (sum[0] + sum[1]) - plane_.height, above = std::abs(height), radius = ball_.radius;
    side = above > radius ? (height > 0 ? PlaneSide::InFront : PlaneSide::Behind) : PlaneSide::Intersects;
    // As in HeightQuery::knows_side.
    return std::abs(above - radius) > bounds::kGivenHeight * widest_ + plane_.error;
  }

 private:
  static __attribute__((always_inline)) DoublePair magnitude(const DoublePair& a) {
    using Bits = std::int64_t __attribute__((vector_size(sizeof a)));
    return reinterpret_cast<DoublePair>(reinterpret_cast<Bits>(a) & (Bits{} + INT64_MAX));
  }
  static __attribute__((always_inline)) DoublePair larger_of(const DoublePair& a, const DoublePair& b) {
#if defined(__SSE2__)
    return _mm_max_pd(a, b);
#else
    return DoublePair{a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
#endif
  }

  const Ball& ball_;
  const GivenPlane& plane_;
  DoublePair xy_, z_;  ///< of the centre; the second number of z is the radius
  double widest_;      ///< the largest number of the ball
};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

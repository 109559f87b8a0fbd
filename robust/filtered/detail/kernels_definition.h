// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/exact/exact.h"
#include "robust/filtered/detail/kernels.h"
#include "robust/filtered/detail/polygon_query.h"
#include "robust/filtered/detail/triangle_closest.h"
#include "robust/filtered/detail/triangle_groups_contact.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Returns whether the ball's numbers are small enough for the polygon's frame.
TOUCHSTONE_INLINE bool frame_reaches(const Ball& ball, const PreparedPolygon::Parts& parts) {
  if (!parts.frame) return false;
  const double limit = parts.frame->reachable;
  return std::abs(ball.center[0]) <= limit && std::abs(ball.center[1]) <= limit && std::abs(ball.center[2]) <= limit &&
         ball.radius <= limit;
}

/// Answers in the frame if the ball is within its limits, else by `exact`. Never inlined, so that it returns only after
/// the caller's floating-point state is restored.
template <auto in_frame, auto otherwise, class Result, class Counts>
__attribute__((noinline)) Result ask(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (frame_reaches(ball, parts)) [[likely]] {
    // Subnormal coordinates are scaled up first, and must not be flushed to zero there.
    std::optional<OwnFloatingPointState> nearest;
    if (parts.frame->exponent < Frame::kSubnormal) [[unlikely]]
      nearest.emplace();
    PolygonQuery<Counts> query(ball, parts, counts);
    return pinned((query.*in_frame)());
  }
  counts.count(Stage::BigInteger);
  return otherwise(ball, parts.exact());
}

/// The first stage alone, without what later stages need. Asks them if it is not certain.
template <class Counts>
PlaneSide plane_side(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (frame_reaches(ball, parts) && parts.frame->exponent >= Frame::kSubnormal) [[likely]] {
    const HeightQuery query(ball, *parts.frame);
    if (query.knows_side()) [[likely]] {
      counts.count(Stage::Double);
      return query.side();
    }
  }
  return ask<&PolygonQuery<Counts>::plane_side,
             static_cast<PlaneSide (*)(const Ball&, const exact::PreparedPolygon&)>(exact::plane_side), PlaneSide>(
      ball, parts, counts);
}

template <class Counts>
inline constexpr KernelTable<Counts> kKernelTable{
    .triangle_contact = contact<Counts>,
    .triangle_nearest = nearest_feature<Counts>,
    .triangle_distance = feature_distance<Counts>,
    .triangle_point = feature_point<Counts>,
    .set_contact = set_contact<Counts>,
    .set_any_contact = set_any_contact<Counts>,
    .set_triangles_hit = set_triangles_hit<Counts>,
    .contact = ask<&PolygonQuery<Counts>::contact,
                   static_cast<bool (*)(const Ball&, const exact::PreparedPolygon&)>(exact::contact), bool, Counts>,
    .relation =
        ask<&PolygonQuery<Counts>::relation,
            static_cast<Relation (*)(const Ball&, const exact::PreparedPolygon&)>(exact::relation), Relation, Counts>,
    .plane_side = plane_side<Counts>,
    .foot = ask<&PolygonQuery<Counts>::foot,
                static_cast<PointLocation (*)(const Ball&, const exact::PreparedPolygon&)>(exact::foot), PointLocation,
                Counts>,
    .edges_hit =
        ask<&PolygonQuery<Counts>::edges_hit,
            static_cast<std::vector<std::size_t> (*)(const Ball&, const exact::PreparedPolygon&)>(exact::edges_hit),
            std::vector<std::size_t>, Counts>,
    .answer = ask<&PolygonQuery<Counts>::answer,
                  static_cast<Answer (*)(const Ball&, const exact::PreparedPolygon&)>(exact::answer), Answer, Counts>,
};

inline void balls_contact(std::span<const Ball> balls, const PreparedPolygon::Parts& parts, std::span<bool> touches) {
  NoCounts counts;
  for (std::size_t i = 0; i < balls.size(); ++i) touches[i] = kKernelTable<NoCounts>.contact(balls[i], parts, counts);
}

inline void triangles_contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches) {
  NoCounts counts;
  for (std::size_t i = 0; i < triangles.size(); ++i) touches[i] = contact(view_of(ball, triangles[i]), counts);
}

/// The kernels of the target that this is compiled for.
inline constexpr Kernels kKernels{kKernelTable<NoCounts>, kKernelTable<StageCounts>, balls_contact, triangles_contact,
                                  newell_sums};

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

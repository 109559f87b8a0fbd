// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/exact/exact.h"
#include "robust/filtered/detail/ball_lanes.h"
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
    if (parts.frame->unit.exponent < Frame::kSubnormal) [[unlikely]]
      nearest.emplace();
    PolygonQuery<Counts> query(ball, parts, counts);
    return pinned((query.*in_frame)());
  }
  counts.count(Stage::BigInteger);
  return otherwise(ball, parts.exact());
}

/// Returns whether the first stage may run in the caller's floating-point state.
TOUCHSTONE_INLINE bool frame_reaches_at_once(const Ball& ball, const PreparedPolygon::Parts& parts) {
  return frame_reaches(ball, parts) && parts.frame->unit.exponent >= Frame::kSubnormal;
}

/// Returns the certain sign of the ball's distance from the polygon less the radius; 0 if the first stage is unsure.
template <class Counts>
TOUCHSTONE_INLINE int certain_sign(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (!frame_reaches_at_once(ball, parts)) return 0;
  const int sign = certain_distance_sign(HeightQuery(ball, *parts.frame), *parts.frame, *parts.edges);
  if (sign != 0) counts.count(Stage::Double);
  return sign;
}

// The first stage comes alone, without what later stages need. If it is not certain, all stages start anew.
template <class Counts>
TOUCHSTONE_INLINE bool contact(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (const int sign = certain_sign(ball, parts, counts); sign != 0) [[likely]]
    return sign < 0;
  return ask<&PolygonQuery<Counts>::contact,
             static_cast<bool (*)(const Ball&, const exact::PreparedPolygon&)>(exact::contact), bool>(ball, parts,
                                                                                                      counts);
}

template <class Counts>
Relation relation(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  if (const int sign = certain_sign(ball, parts, counts); sign != 0) [[likely]]
    return sign < 0 ? Relation::Overlapping : Relation::Separate;
  return ask<&PolygonQuery<Counts>::relation,
             static_cast<Relation (*)(const Ball&, const exact::PreparedPolygon&)>(exact::relation), Relation>(
      ball, parts, counts);
}

template <class Counts>
bool polygon_contact(const Ball& ball, const PreparedPolygon::Parts& parts, Counts& counts) {
  return pinned(contact(ball, parts, counts));
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
    .contact = polygon_contact<Counts>,
    .relation = relation<Counts>,
    .plane_side = ask<&PolygonQuery<Counts>::plane_side,
                      static_cast<PlaneSide (*)(const Ball&, const exact::PreparedPolygon&)>(exact::plane_side),
                      PlaneSide, Counts>,
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
  const auto reached = [&parts](const Ball& ball) { return frame_reaches_at_once(ball, parts); };
  std::size_t i = 0;
  for (; i + kLanes <= balls.size() && parts.edges; i += kLanes) {
    const std::span<const Ball> four = balls.subspan(i, kLanes);
    CertainContacts certain{0, 0};
    if (reached(four[0]) && reached(four[1]) && reached(four[2]) && reached(four[3])) [[likely]]
      certain = certain_contacts(four.data(), *parts.frame, *parts.edges);
    for (unsigned lane = 0; lane < kLanes; ++lane)
      touches[i + lane] = ((certain.touching | certain.separate) >> lane & 1) != 0 ? (certain.touching >> lane & 1) != 0
                                                                                   : contact(four[lane], parts, counts);
  }
  for (; i < balls.size(); ++i) touches[i] = contact(balls[i], parts, counts);
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

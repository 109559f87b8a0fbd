// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robust/exact/exact.h"
#include "robust/filtered/detail/polygon_query.h"

/// All stages for a ball and a prepared polygon.
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

// The first stage comes alone, without what later stages need. If it is not certain, all stages start again.
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

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

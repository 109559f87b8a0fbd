// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "robust/filtered/detail/ball_triangle_view.h"
#include "robust/filtered/detail/bigint_sign.h"
#include "robust/filtered/detail/numbers/lane_vector.h"
#include "robust/filtered/detail/sign_ladder.h"

/// Contact that depends on one sign of a triangle alone. Double-doubles come first, without a branch on the sign, which
/// a processor could not predict.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

[[nodiscard]] inline Vector3<DoubleDouble> exact_difference(const double* a, const double* b) {
  return {two_difference(a[0], b[0]), two_difference(a[1], b[1]), two_difference(a[2], b[2])};
}
[[nodiscard]] inline Vector3<DoubleDouble> exact_edge(const BallTriangleView& view, int i) {
  return exact_difference(view.vertex[i == 2 ? 0 : i + 1], view.vertex[i]);
}

/// Returns the sign that belongs to edge i. `maxima`: that of the centre as seen from the edge, with r, and that of all
/// edges. Requires round to nearest, without flush-to-zero.
template <SignKind kind, Stage first = Stage::Permanent, class Counts>
[[nodiscard]] int exact_sign(const BallTriangleView& view, Maxima maxima, int i, Counts& counts) {
  constexpr bool needs_normal = kind == SignKind::Plane || kind == SignKind::Side;
  const Vector3<DoubleDouble> to_center = exact_difference(view.center, view.vertex[i]), along = exact_edge(view, i);
  maxima.normal = 2 * maxima.edge * maxima.edge;
  const Vector3<DoubleDouble> normal_edges[] = {needs_normal ? exact_edge(view, 0) : along,
                                                needs_normal ? exact_edge(view, 1) : along};
  const auto normal = needs_normal ? signs::normal(normal_edges[0], normal_edges[1]) : along;
  const EdgeOperands operands{to_center, along, normal, view.radius(), 0, maxima, false, normal_edges, false};
  return exact_sign<kind, first>(operands, counts, [&] { return bigint_sign(kind, view, i); });
}

/// The numbers of an edge whose components are lanes.
struct LaneView {
  const BallTriangleView& view;
  int i;

  [[nodiscard]] TOUCHSTONE_INLINE LaneVector to_center() const { return difference(view.center, view.vertex[i]); }
  [[nodiscard]] TOUCHSTONE_INLINE LaneVector edge() const { return edge(i); }
  [[nodiscard]] TOUCHSTONE_INLINE LaneVector normal() const { return signs::normal(edge(0), edge(1)); }
  [[nodiscard]] TOUCHSTONE_INLINE Radius radius() const { return {view.radius()}; }

 private:
  [[nodiscard]] TOUCHSTONE_INLINE LaneVector edge(int k) const {
    return difference(view.vertex[k == 2 ? 0 : k + 1], view.vertex[k]);
  }
};

/// Returns whether the ball's numbers have few bits, as on a lattice, where integers decide what double-doubles cannot.
[[nodiscard]] TOUCHSTONE_INLINE bool has_few_bits(const double* ball) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 4; ++i) bits |= std::bit_cast<std::uint64_t>(ball[i]);
  return (bits & 0xffff'ffff) == 0;
}

template <SignKind kind, class Counts>
TOUCHSTONE_INLINE bool contact_by(const BallTriangleView& view, const LoneSign& sign, int i, Counts& counts) {
  Maxima maxima{sign.to_center[i], std::max(std::max(sign.edge[0], sign.edge[1]), sign.edge[2]), 0};
  if constexpr (uses<Counts>(Stage::DoubleDouble)) {
    if (has_few_bits(view.center)) return exact_sign<kind, Stage::DoubleDouble>(view, maxima, i, counts) <= 0;
    maxima.normal = 2 * maxima.edge * maxima.edge;
    const double value = expression<kind>(LaneView{view, i});
    const double error = bounds::kDoubleDoubleUnit * bound<kind>(maxima) + bounds::kTiny;
    if (std::abs(value) > error) [[likely]] {
      counts.count(Stage::DoubleDouble);
      return value < 0;
    }
    return exact_sign<kind, Stage::FixedInteger>(view, maxima, i, counts) <= 0;
  } else {
    return exact_sign<kind>(view, maxima, i, counts) <= 0;
  }
}

/// Returns whether ball and triangle touch. Requires that `sign` alone decides it, round to nearest, and no
/// flush-to-zero.
template <class Counts>
TOUCHSTONE_INLINE bool contact_by_lone_sign(const BallTriangleView& view, const LoneSign& sign, Counts& counts) {
  const int place = std::countr_zero(sign.bit);
  if (place == LoneSign::kPlane) return contact_by<SignKind::Plane>(view, sign, 0, counts);
  if (place < LoneSign::kLines) return contact_by<SignKind::Vertex>(view, sign, place, counts);
  return contact_by<SignKind::Line>(view, sign, place - LoneSign::kLines, counts);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/contact/answer.h"
#include "geometry/detail/floating_point_state.h"
#include "robust/filtered/detail/numbers/lane_vector.h"
#include "robust/filtered/detail/signs/sign_ladder.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
#include "robust/filtered/detail/triangle/scaled_triangle.h"
#include "robust/filtered/detail/triangle/triangle_filter.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

// Contact that depends on one sign of a triangle alone. Double-doubles come first, without a branch on the sign, which
// a processor could not predict.

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
  constexpr bool needs_normal = kind == SignKind::Plane || kind == SignKind::Side || kind == SignKind::Front;
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
  [[nodiscard]] TOUCHSTONE_INLINE Unnormalised radius() const { return {view.radius()}; }

 private:
  [[nodiscard]] TOUCHSTONE_INLINE LaneVector edge(int k) const {
    constexpr int next[] = {1, 2, 0};  // a comparison would be a branch
    return difference(view.vertex[next[k]], view.vertex[k]);
  }
};

/// Returns whether the ball's numbers have few bits, as on a lattice, where integers decide what double-doubles cannot.
[[nodiscard]] TOUCHSTONE_INLINE bool has_few_bits(const double* ball) {
  std::uint64_t bits = 0;
  for (int i = 0; i < 4; ++i) bits |= std::bit_cast<std::uint64_t>(ball[i]);
  return (bits & 0xffff'ffff) == 0;
}

/// Returns whether the sign is not positive, by the stages from `first` on, which may raise any flag. Inlined, they
/// would take registers from the stages before.
template <SignKind kind, Stage first, class Counts>
__attribute__((noinline)) bool contact_by(const BallTriangleView& view, const Maxima& maxima, int i, Counts& counts) {
  const FloatingPointState nearest;
  return pinned(exact_sign<kind, first>(view, maxima, i, counts) <= 0);
}

template <SignKind kind, class Counts>
TOUCHSTONE_INLINE bool contact_by(const BallTriangleView& view, const LoneSign& sign, int i, Counts& counts) {
  Maxima maxima{sign.to_center[i], std::max(std::max(sign.edge[0], sign.edge[1]), sign.edge[2]), 0};
  if (has_few_bits(view.center)) return contact_by<kind, Stage::DoubleDouble>(view, maxima, i, counts);
  maxima.normal = 2 * maxima.edge * maxima.edge;
  const Estimate<double> number =
      estimate(expression<kind>(LaneView{view, i}), bounds::kUnnormalised * bound<kind>(maxima));
  if (std::abs(number.value) > number.error) [[likely]] {
    counts.count(Stage::DoubleDouble);
    return number.value < 0;
  }
  return contact_by<kind, Stage::FixedInteger>(view, maxima, i, counts);
}

/// Returns whether ball and triangle touch. Requires that `sign` alone decides it, round to nearest, and no
/// flush-to-zero. Raises no flags except those that triangle_filter may raise.
template <class Counts>
TOUCHSTONE_INLINE bool contact_by_lone_sign(const BallTriangleView& view, const LoneSign& sign, Counts& counts) {
  const int place = std::countr_zero(sign.bit);
  if (place == LoneSign::kPlane) return contact_by<SignKind::Plane>(view, sign, 0, counts);
  if (place < LoneSign::kLines) return contact_by<SignKind::Vertex>(view, sign, place, counts);
  return contact_by<SignKind::Line>(view, sign, place - LoneSign::kLines, counts);
}

/// A triangle and a ball after a first stage that could not decide contact. Uses the signs that are certain and
/// computes the others exactly.
template <class Counts>
class UnsureTriangle {
 public:
  /// Requires round to nearest, without flush-to-zero.
  UnsureTriangle(const BallTriangleView& view, const TriangleSigns& signs, Counts& counts)
      : view_(view), signs_(signs), counts_(counts) {}

  /// Returns whether all differences are so small that scaling by a power of two may avoid underflow.
  [[nodiscard]] bool tiny() const { return std::max(signs_.to_center[0], largest_edge()) < 0x1p-30; }

  [[nodiscard]] bool contact() const { return degenerate() || foot_outside() ? edges_touch() : plane_sign() <= 0; }

  /// Returns the feature that contains the point closest to the centre. The radius does not matter.
  [[nodiscard]] Feature nearest() const {
    const auto side = [this](int i) { return sign<SignKind::Side>(signs_.side, i); };
    const auto along = [this](int i) { return sign<SignKind::Along>(signs_.along, i); };
    const auto beyond = [this](int i) { return sign<SignKind::Beyond>(signs_.beyond, i); };
    const bool has_face = !degenerate();
    bool inner[3];
    for (int i = 0; i < 3; ++i) inner[i] = has_face && side(i) > 0;
    if (inner[0] && inner[1] && inner[2]) return {Feature::Kind::Face, 0};
    // A triangle is convex and has one closest point. It lies on an edge if the foot is beyond the edge's line, or the
    // triangle degenerate, and projects between its ends; else at a vertex from which both edges lead away.
    for (int i = 0; i < 3; ++i)
      if (!inner[i] && along(i) > 0 && beyond(i) < 0) return {Feature::Kind::Edge, static_cast<std::size_t>(i)};
    for (int i = 0; i < 2; ++i)
      if (along(i) <= 0 && beyond((i + 2) % 3) >= 0) return {Feature::Kind::Vertex, static_cast<std::size_t>(i)};
    return {Feature::Kind::Vertex, 2};
  }

  /// Exact differences; the normal is known to bounds::kNormal.
  struct EdgeView {
    Vector3<DoubleDouble> to_center, edge, normal;
    Maxima maxima;
    bool no_normals[3];
    static constexpr bool lifted = false;
    /// The error of the normal's components, in units of bounds::kClosest times the maximum.
    static constexpr double kNormalError = 1;
    [[nodiscard]] DoubleDouble per_normal_square() const { return reciprocal(dot(normal, normal)); }
    /// Returns whether this component of the normal is certainly zero.
    [[nodiscard]] bool no_normal(int axis) const { return no_normals[axis]; }
  };
  [[nodiscard]] EdgeView edge_view(int i) const {
    const double longest = largest_edge();
    const Vector3<DoubleDouble> u = edge(0), v = edge(1);
    const Vector3<DoubleDouble> normal = signs::normal(u, v);
    return {exact_difference(view_.center, view_.vertex[i]),
            edge(i),
            normal,
            {signs_.to_center[i], longest, 2 * longest * longest},
            {certainly_zero(u, v, normal, 0), certainly_zero(u, v, normal, 1), certainly_zero(u, v, normal, 2)}};
  }

 private:
  [[nodiscard]] Vector3<DoubleDouble> edge(int i) const { return exact_edge(view_, i); }
  [[nodiscard]] double largest_edge() const {
    return std::max(std::max(signs_.edge[0], signs_.edge[1]), signs_.edge[2]);
  }

  template <SignKind kind>
  [[nodiscard]] int sign(const CertainSigns& certain, int i) const {
    if (const int known = certain.of(i)) return known;
    return exact_sign<kind>(view_, {signs_.to_center[i], largest_edge(), 0}, i, counts_);
  }
  [[nodiscard]] int plane_sign() const {
    for (int i = 0; i < 3; ++i)
      if (const int known = signs_.plane.of(i)) return known;
    return sign<SignKind::Plane>({}, 0);
  }

  /// Returns whether the triangle is degenerate. Then the normal is 0, and with it the signs of sides and plane.
  [[nodiscard]] bool degenerate() const {
    const unsigned certain =
        signs_.side.positive | signs_.side.negative | signs_.plane.positive | signs_.plane.negative;
    if (certain != 0 || !is_degenerate(view_.vertex)) return false;
    counts_.count(Stage::Permanent);
    return true;
  }
  [[nodiscard]] bool foot_outside() const {
    if (signs_.side.negative != 0) return true;
    for (int i = 0; i < 3; ++i)
      if (sign<SignKind::Side>(signs_.side, i) < 0) return true;
    return false;
  }
  [[nodiscard]] bool edges_touch() const {
    for (unsigned edges = signs_.reachable; edges != 0; edges &= edges - 1)
      if (edge_touches(std::countr_zero(edges))) return true;
    return false;
  }
  /// Tests vertex i together with edge i. The end of the edge is tested with the next edge.
  [[nodiscard]] bool edge_touches(int i) const {
    if (sign<SignKind::Vertex>(signs_.vertex, i) <= 0) return true;
    if (signs_.line.of(i) > 0) return false;
    return sign<SignKind::Along>(signs_.along, i) > 0 && sign<SignKind::Beyond>(signs_.beyond, i) < 0 &&
           sign<SignKind::Line>(signs_.line, i) <= 0;
  }

  const BallTriangleView& view_;
  const TriangleSigns& signs_;
  Counts& counts_;
};

/// Returns whether ball and triangle touch. exact(kind, edge) computes the signs that are not certain.
template <class ExactSign>
bool contact_by(const TriangleSigns& signs, const ExactSign& exact) {
  const auto sign = [&exact](SignKind kind, const CertainSigns& certain, int i) {
    const int known = certain.of(i);
    return known != 0 ? known : exact(kind, i);
  };
  bool outside = signs.side.negative != 0, has_face = false;
  for (int i = 0; i < 3 && !outside; ++i) {
    const int side = sign(SignKind::Side, signs.side, i);
    outside = side < 0, has_face = has_face || side > 0;
  }
  if (!outside && has_face) return sign(SignKind::Plane, signs.plane, 0) <= 0;  // without a face all sides are 0
  for (int i = 0; i < 3; ++i) {
    if (sign(SignKind::Vertex, signs.vertex, i) <= 0) return true;
    if (signs.line.of(i) > 0) continue;
    if (sign(SignKind::Along, signs.along, i) > 0 && sign(SignKind::Beyond, signs.beyond, i) < 0 &&
        sign(SignKind::Line, signs.line, i) <= 0)
      return true;
  }
  return false;
}

/// The same, with these signs in integers of any size.
inline bool bigint_contact(const BallTriangleView& view, const TriangleSigns& signs) {
  return contact_by(signs, [&view](SignKind kind, int i) { return bigint_sign(kind, view, i); });
}

/// Returns whether ball and triangle touch, after scaling very large or very small numbers to ordinary size.
template <class Counts>
__attribute__((noinline)) bool scaled_contact(const BallTriangleView& view, double largest, Counts& counts) {
  TriangleSigns signs;
  if (const FilterResult result = scaled_filter(view, signs); result != FilterResult::Unsure) {
    counts.count(Stage::Double);
    return result == FilterResult::Yes;
  }
  const ScaledTriangle<BallTriangleView> scaled(view, largest);
  if (!scaled.exact()) {
    counts.count(Stage::BigInteger);
    return bigint_contact(view, signs);
  }
  const BallTriangleView same = scaled.view();
  (void)triangle_filter<true>(same, signs);
  return UnsureTriangle<Counts>(same, signs, counts).contact();
}

/// Returns whether ball and triangle touch, by as many signs as that takes. Requires round to nearest, without
/// flush-to-zero.
template <class Counts>
__attribute__((noinline)) bool contact_by_signs(const BallTriangleView& view, Counts& counts) {
  TriangleSigns signs;
  const FilterResult result = triangle_filter(view, signs);
  if (result == FilterResult::OutOfRange) return scaled_contact(view, largest_number(view), counts);
  if (result != FilterResult::Unsure) {  // in the caller's floating-point state it was
    counts.count(Stage::Double);
    return result == FilterResult::Yes;
  }
  const UnsureTriangle<Counts> triangle(view, signs, counts);
  if (triangle.tiny())
    if (const double largest = largest_number(view); largest < 0x1p-30) return scaled_contact(view, largest, counts);
  return triangle.contact();
}

/// Returns whether ball and triangle touch, for queries that the first stage could not decide, in any state.
template <class Counts>
__attribute__((noinline)) bool contact_in_own_state(const BallTriangleView& view, const LoneSign& sign,
                                                    Counts& counts) {
  const FloatingPointState nearest;
  return pinned(sign.bit != 0 ? contact_by_lone_sign(view, sign, counts) : contact_by_signs(view, counts));
}

/// The same, faster where nothing has to be set or restored.
template <class Counts>
__attribute__((noinline)) bool unsure_contact(const BallTriangleView& view, const LoneSign& sign, Counts& counts) {
  if (sign.bit != 0 && FloatingPointState::is_found()) [[likely]]
    return contact_by_lone_sign(view, sign, counts);
  return contact_in_own_state(view, sign, counts);
}

template <class Counts>
TOUCHSTONE_INLINE bool contact(BallTriangleView view, Counts& counts) {
  LoneSign lone;
  const FilterResult result = triangle_filter(view, lone);
  if (result >= FilterResult::Unsure) [[unlikely]]
    return unsure_contact(view, lone, counts);
  counts.count(Stage::Double);
  return result == FilterResult::Yes;
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "robust/filtered/detail/motion/capsule_filter.h"
#include "robust/filtered/detail/triangle_contact.h"

/// The second stage for the contact of a moving ball with a triangle: the signs that doubles leave open, in
/// double-doubles.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Decides with the signs of signs.h what may be hit. A sign that is not certain is 0.
class CapsuleInDoubles {
 public:
  /// Requires round to nearest.
  CapsuleInDoubles(const MotionTriangleView& view, const CapsuleSigns& signs)
      : view_(view), signs_(signs), velocity_(difference(view.motion + 4, view.motion)) {}

  [[nodiscard]] FilterResult vertex(int i) const {
    const double maximum = signs_.center[i] * signs_.velocity;
    const auto to_center = from(i), to_end = from_end(i);
    const int approaches = sign(signs::along(to_center, velocity_), bounds::kAlong * maximum);
    const int departs = sign(signs::along(to_end, velocity_), bounds::kAlong * maximum);
    if (approaches > 0 || departs < 0) return FilterResult::No;
    return hit(sign(signs::line(to_center, velocity_, radius()), bounds::kLine * maximum * maximum),
               approaches < 0 && departs > 0);
  }
  [[nodiscard]] FilterResult edge(int i) const {
    const double all = signs_.center[i] * signs_.edge[i] * signs_.velocity;
    const double edge_bound = bounds::kOnEdge * (all * signs_.velocity);
    const double way_bound = bounds::kOnWay * (all * signs_.edge[i]);
    const int next = i == 2 ? 0 : i + 1;
    const auto to_center = from(i), to_end = from_end(i), edge = difference(view_.vertex[next], view_.vertex[i]);
    const int after_start = sign(signs::on_edge(to_center, edge, velocity_), edge_bound);
    const int after_end = sign(signs::on_edge(from(next), edge, velocity_), edge_bound);
    const int starts_past = sign(signs::on_way(to_center, edge, velocity_), way_bound);
    const int ends_past = sign(signs::on_way(to_end, edge, velocity_), way_bound);
    if (after_start < 0 || after_end > 0 || starts_past > 0 || ends_past < 0) return FilterResult::No;
    return hit(sign(signs::lines(to_center, edge, velocity_, radius()), bounds::kLines * all * all),
               after_start > 0 && after_end < 0 && starts_past < 0 && ends_past > 0);
  }

 private:
  static Vector3<DoubleDouble> difference(const double* a, const double* b) {
    return {two_difference(a[0], b[0]), two_difference(a[1], b[1]), two_difference(a[2], b[2])};
  }
  [[nodiscard]] Vector3<DoubleDouble> from(int i) const { return difference(view_.motion, view_.vertex[i]); }
  [[nodiscard]] Vector3<DoubleDouble> from_end(int i) const { return difference(view_.motion + 4, view_.vertex[i]); }
  [[nodiscard]] DoubleDouble radius() const { return view_.radius(); }
  /// Returns the sign of a value with error `bound` kDoubleDoubleUnit + kTiny.
  static int sign(const DoubleDouble& value, double bound) {
    const double largest = bounds::kDoubleDoubleUnit * bound + bounds::kTiny;
    return (value.high > largest) - (value.high < -largest);
  }
  /// `out`: the sign of the gap; `within`: whether the nearest points certainly lie inside.
  static FilterResult hit(int out, bool within) {
    if (out > 0) return FilterResult::No;
    return out < 0 && within ? FilterResult::Yes : FilterResult::Unsure;
  }

  const MotionTriangleView& view_;
  const CapsuleSigns& signs_;
  const Vector3<DoubleDouble> velocity_;
};

/// Returns whether the capsule touches the triangle, if double-doubles can decide it. Requires round to nearest.
template <class Counts>
FilterResult unsure_capsule(const MotionTriangleView& view, const CapsuleSigns& signs, Counts& counts) {
  const double end[] = {view.to(0), view.to(1), view.to(2), view.radius()};
  if (signs.at_start != FilterResult::No && contact(BallTriangleView{view.vertex, view.motion}, counts))
    return FilterResult::Yes;
  if (signs.at_end != FilterResult::No && contact(BallTriangleView{view.vertex, end}, counts)) return FilterResult::Yes;
  const CapsuleInDoubles capsule(view, signs);
  bool unsure = signs.may_pierce, touches = false;
  const auto consider = [&](FilterResult result) {
    touches = result == FilterResult::Yes;
    unsure = unsure || result == FilterResult::Unsure;
  };
  for (unsigned edges = signs.edges; edges != 0 && !touches; edges &= edges - 1)
    consider(capsule.edge(std::countr_zero(edges)));
  for (unsigned vertices = signs.vertices; vertices != 0 && !touches; vertices &= vertices - 1)
    consider(capsule.vertex(std::countr_zero(vertices)));
  if (!touches && unsure) return FilterResult::Unsure;
  counts.count(Stage::DoubleDouble);
  return touches ? FilterResult::Yes : FilterResult::No;
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "robust/filtered/detail/signs/closest_point.h"
#include "robust/filtered/detail/triangle/exact_triangle.h"
#include "robust/filtered/detail/triangle/triangle_contact.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// A triangle relative to a centre, scaled by a power of two if its numbers are far from 1. Meets the requirements of
/// closest_point.h.
template <class Counts>
class ExactTriangle {
 public:
  /// Requires a view with a radius of 0, and round to nearest without flush-to-zero during its lifetime. The radius is
  /// that of the ball whose depth is asked.
  ExactTriangle(const BallTriangleView& view, Counts& counts, double radius = 0)
      : given_(view), view_(view), given_radius_(radius), counts_(counts) {
    if (const double largest = largest_number(view); !(largest >= 0x1p-30 && largest <= 0x1p30)) {
      scaled_.emplace(view, largest);
      view_ = scaled_->view();
    }
    scales_ = !scaled_ || scaled_->exact();
    if (scales_) (void)triangle_filter<true>(view_, signs_);
  }
  ExactTriangle(const ExactTriangle&) = delete;
  ExactTriangle& operator=(const ExactTriangle&) = delete;

  /// Returns the feature that contains the closest point.
  [[nodiscard]] Feature nearest() const {
    if (scales_) return triangle().nearest();
    counts_.count(Stage::BigInteger);
    return bigint_nearest(given_);
  }

  [[nodiscard]] Counts& counts() const { return counts_; }
  [[nodiscard]] bool scales() const { return scales_; }
  [[nodiscard]] double unscaled(double length) const { return scaled_ ? scaled_->unit().unscaled(length) : length; }
  [[nodiscard]] double radius() const { return scaled_ ? scaled_->unit().scaled(given_radius_) : given_radius_; }
  [[nodiscard]] bool radius_scales() const { return !scaled_ || scaled_->unit().is_exact(given_radius_); }
  [[nodiscard]] double center(int axis) const { return view_.center[axis]; }
  [[nodiscard]] double vertex(std::size_t i, int axis) const { return view_.vertex[i][axis]; }
  [[nodiscard]] double given_vertex(std::size_t i, int axis) const { return given_.vertex[i][axis]; }
  [[nodiscard]] static bool lifts(int) { return false; }
  [[nodiscard]] static DoubleDouble lift(std::size_t) { return {}; }
  /// Returns the edge. Keeps the last one.
  [[nodiscard]] const auto& edge_view(std::size_t edge) const {
    kept_.emplace(triangle().edge_view(static_cast<int>(edge)));
    return *kept_;
  }
  [[nodiscard]] double bigint_point(const Feature& feature, int axis) const {
    return detail::bigint_point(given_, feature, axis);
  }
  [[nodiscard]] double bigint_distance(const Feature& feature) const {
    return detail::bigint_distance(given_, feature);
  }
  [[nodiscard]] Eigen::Vector3d bigint_normal(const Feature& feature) const {
    return detail::bigint_normal(given_, feature);
  }
  [[nodiscard]] double bigint_depth(const Feature& feature) const {
    return detail::bigint_depth(given_, given_radius_, feature);
  }

 private:
  [[nodiscard]] UnsureTriangle<Counts> triangle() const { return {view_, signs_, counts_}; }

  BallTriangleView given_, view_;
  std::optional<ScaledTriangle<BallTriangleView>> scaled_;
  double given_radius_;
  Counts& counts_;
  TriangleSigns signs_;
  mutable std::optional<typename UnsureTriangle<Counts>::EdgeView> kept_;
  bool scales_;
};

template <class Counts>
Feature nearest_feature(BallTriangleView view, Counts& counts) {
  const FloatingPointState nearest;
  return pinned(ExactTriangle<Counts>(view, counts).nearest());
}

template <class Counts>
double feature_distance(BallTriangleView view, const Feature& feature, Counts& counts) {
  const FloatingPointState nearest;
  const ExactTriangle<Counts> triangle(view, counts);
  return pinned(ClosestPointOnFeature(triangle, feature).distance());
}

/// Writes the closest point and, if asked for, the depth.
template <class Counts>
void closest_point(BallTriangleView view, ClosestPoint& point, double* depth, Counts& counts) {
  const FloatingPointState nearest;
  const double center[] = {view.center[0], view.center[1], view.center[2], 0};
  const ExactTriangle<Counts> triangle({view.vertex, center}, counts, view.radius());
  const Feature feature = triangle.nearest();
  const ClosestPointOnFeature closest(triangle, feature);
  point = {.feature = feature,
           .point = {closest.coordinate(0), closest.coordinate(1), closest.coordinate(2)},
           .distance = closest.distance(),
           .contact_normal = closest.contact_normal()};
  if (depth != nullptr) *depth = closest.depth();
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "robust/filtered/detail/bigint_triangle.h"
#include "robust/filtered/detail/closest_point.h"
#include "robust/filtered/detail/triangle_contact.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// A triangle as seen from a centre, times a power of two where its numbers are far from 1: what closest_point.h asks
/// of edges.
template <class Counts>
class SeenTriangle {
 public:
  /// The question's radius must be 0. Requires round to nearest, without flush-to-zero, while it lives.
  SeenTriangle(const TriangleQuestion& question, Counts& counts) : given_(question), seen_(question), counts_(counts) {
    if (const double largest = largest_number(question); !(largest >= 0x1p-30 && largest <= 0x1p30)) {
      scaled_.emplace(question, largest);
      exponent_ = scaled_->exponent();
      seen_ = scaled_->question();
    }
    scales_ = !scaled_ || scaled_->exact();
    if (scales_) (void)triangle_filter<true>(seen_, signs_);
  }
  SeenTriangle(const SeenTriangle&) = delete;
  SeenTriangle& operator=(const SeenTriangle&) = delete;

  /// The feature that holds the closest point.
  [[nodiscard]] Feature nearest() const {
    if (scales_) return triangle().nearest();
    counts_.count(Stage::Unlimited);
    return unlimited_nearest(given_);
  }

  [[nodiscard]] Counts& counts() const { return counts_; }
  [[nodiscard]] bool scales() const { return scales_; }
  [[nodiscard]] int exponent() const { return exponent_; }
  [[nodiscard]] double center(int axis) const { return seen_.center[axis]; }
  [[nodiscard]] double vertex(std::size_t i, int axis) const { return seen_.vertex[i][axis]; }
  [[nodiscard]] double given_vertex(std::size_t i, int axis) const { return given_.vertex[i][axis]; }
  [[nodiscard]] static bool lifts(int) { return false; }
  [[nodiscard]] static DoubleDouble lift(std::size_t) { return {}; }
  [[nodiscard]] auto seen(std::size_t edge) const { return triangle().seen(static_cast<int>(edge)); }
  [[nodiscard]] double unlimited_point(const Feature& feature, int axis) const {
    return filtered::unlimited_point(given_, feature, axis);
  }
  [[nodiscard]] double unlimited_distance(const Feature& feature) const {
    return filtered::unlimited_distance(given_, feature);
  }

 private:
  [[nodiscard]] UnsureTriangle<Counts> triangle() const { return {seen_, signs_, counts_}; }

  TriangleQuestion given_, seen_;
  std::optional<ScaledTriangle> scaled_;
  Counts& counts_;
  TriangleSigns signs_;
  int exponent_ = 0;
  bool scales_;
};

template <class Counts>
Feature nearest_feature(TriangleQuestion question, Counts& counts) {
  const FloatingPointState nearest;
  return pinned(SeenTriangle<Counts>(question, counts).nearest());
}

template <class Counts>
double feature_distance(TriangleQuestion question, const Feature& feature, Counts& counts) {
  const FloatingPointState nearest;
  return pinned(distance(SeenTriangle<Counts>(question, counts), feature));
}

template <class Counts>
void feature_point(TriangleQuestion question, const Feature& feature, double (&point)[3], Counts& counts) {
  const FloatingPointState nearest;
  const SeenTriangle<Counts> triangle(question, counts);
  for (int axis = 0; axis < 3; ++axis) point[axis] = closest_point(triangle, feature, axis);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

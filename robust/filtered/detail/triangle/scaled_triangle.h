// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/filtered/detail/numbers/length_unit.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/detail/triangle/triangle_filter.h"

/// Balls and triangles with very large or very small numbers, and with both.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// Returns the largest magnitude of a number of ball and triangle, or of motion and triangle.
template <class View>
double largest_number(const View& view) {
  double largest = 0;
  for (int i = 0; i < View::kNumbers; ++i) largest = std::max(largest, std::abs(view.numbers()[i]));
  for (int i = 0; i < 3; ++i)
    for (const double x : {view.vertex[i][0], view.vertex[i][1], view.vertex[i][2]})
      largest = std::max(largest, std::abs(x));
  return largest;
}

/// Returns the unit in which this largest magnitude is in [1/2, 1), or 0.
inline LengthUnit unit_of(double largest) {
  return LengthUnit(std::ilogb(std::max(largest, std::numeric_limits<double>::denorm_min())) + 1);
}

/// A triangle and a ball, or a motion, times a power of two.
template <class View>
class ScaledTriangle {
 public:
  /// Scales `largest` to [1/2, 1). Requires that it is the largest magnitude of a number of the view.
  ScaledTriangle(const View& view, double largest) : unit_(unit_of(largest)) {
    for (int i = 0; i < 9; ++i) vertex_[i / 3][i % 3] = scaled(view.vertex[i / 3][i % 3]);
    for (int i = 0; i < View::kNumbers; ++i) numbers_[i] = scaled(view.numbers()[i]);
  }
  /// Returns whether no bit was lost.
  [[nodiscard]] bool exact() const { return exact_; }
  [[nodiscard]] const LengthUnit& unit() const { return unit_; }
  [[nodiscard]] View view() const { return {vertex_, numbers_}; }

 private:
  double scaled(double length) {
    exact_ = exact_ && unit_.is_exact(length);
    return unit_.scaled(length);
  }

  LengthUnit unit_;
  bool exact_ = true;
  double vertex_[3][3], numbers_[View::kNumbers];
};

/// The differences of two points, in a unit in which neither has a coordinate of 1 or more.
///
/// Coordinates that are scaled lose at most 2^-1073. That is far below a unit of the maxima from bounds::kSmallest up
/// with which filter_edges computes, so it may take the differences for rounded ones.
struct ScaledDifference {
  double difference[3];
  double radius;  ///< in the same unit

  /// Returns `to` less `from`. Requires round to nearest, and subnormal numbers.
  ScaledDifference(const double* to, const double* from, double given_radius) {
    double largest = given_radius;
    for (int axis = 0; axis < 3; ++axis) largest = std::max({largest, std::abs(to[axis]), std::abs(from[axis])});
    const LengthUnit unit = unit_of(largest);
    for (int axis = 0; axis < 3; ++axis) difference[axis] = unit.scaled(to[axis]) - unit.scaled(from[axis]);
    radius = unit.scaled(given_radius);
  }
};

/// As triangle_filter for numbers of any size, which may be very different. Writes `signs` if the result is Unsure.
/// Requires round to nearest, and subnormal numbers.
inline FilterResult scaled_filter(const BallTriangleView& view, TriangleSigns& signs) {
  double to_center[3][kLanes] = {}, edge[3][kLanes] = {}, radius[kLanes] = {};
  for (int i = 0; i < 3; ++i) {
    const double* const start = view.vertex[i];
    const ScaledDifference from_start(view.center, start, view.radius());
    const ScaledDifference along(view.vertex[i == 2 ? 0 : i + 1], start, 0);
    for (int axis = 0; axis < 3; ++axis) {
      to_center[axis][i] = from_start.difference[axis];
      edge[axis][i] = along.difference[axis];
    }
    radius[i] = from_start.radius;
  }
  const auto lanes = [](const double(&vectors)[3][kLanes]) {
    return Vector3<Pack>{load(vectors[0]), load(vectors[1]), load(vectors[2])};
  };
  const Vector3<Pack> edges = lanes(edge);
  const Vector3<Pack> previous{previous_of_three(edges.x), previous_of_three(edges.y), previous_of_three(edges.z)};
  const TriangleLanes<Pack> triangle(edges, signs::normal(previous, edges));
  return filter_edges<false>(triangle, BallAtTriangle<Pack, true>(triangle, lanes(to_center), load(radius)), signs);
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

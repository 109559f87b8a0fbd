// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "robust/filtered/detail/exact_edges.h"

/// The closest point and the distance, correctly rounded: in double-doubles with a rounding test, and in integers of
/// any size if that is ambiguous.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// A double-double and a bound of its error: 0, or at least 2 u |low|, u = 2^-53. Every nonzero error here includes two
/// units of the value's size (bounds::kDoubleDoubleUnit), which is more.
struct Enclosed {
  DoubleDouble value;
  double error;
};

/// Returns whether all numbers within the error of high + low round to high. Requires |low| <= ulp(high) / 2, an error
/// as in Enclosed, and round to nearest. The sums here are rounded, too, so the error is doubled; toy arithmetic shows
/// for all operands that this suffices.
template <class Number>
constexpr bool surely_nearest(const Number& high, const Number& low, const Number& error) {
  const Number wide = error + error;
  return high + (low + wide) == high && high + (low - wide) == high;  // compared as rounded
}

/// Returns the double nearest to the number times 2^exponent, if every number within the error rounds to it, as a
/// normal double or as an exact zero.
inline std::optional<double> rounded(const Enclosed& number, int exponent) {
  const double high = number.value.high, low = number.value.low;
  if (high == 0 && low == 0 && number.error == 0) return 0.0;            // exact
  assert(number.error == 0 || number.error >= 0x1p-52 * std::abs(low));  // exact
  if (!surely_nearest(high, low, number.error)) return std::nullopt;
  const double result = std::ldexp(high, exponent);
  if (!(std::abs(result) >= 0x1p-1020 && std::abs(result) < 0x1p1023)) return std::nullopt;
  return result;
}

// Below these sizes squares or steps may underflow, and the error bounds do not hold. Above them the effect of
// underflow on a step and on the components of its direction is smaller than the slack in the two units of the result.
inline constexpr double kShortestDirection = 0x1p-100, kSmallestResult = 0x1p-300;

/// Computes each coordinate of the feature's point closest to the centre. `Edges` are those of a prepared polygon
/// (ExactEdges) or of a triangle (ExactTriangle).
///
/// Requires that each component of a direction has a small relative error, except for lifts and kNormalError: then a
/// coordinate that the step hardly changes has an error much smaller than the step.
template <class Edges>
class ClosestPointOnFeature {
 public:
  ClosestPointOnFeature(const Edges& edges, const Feature& feature) : edges_(edges), feature_(feature) {
    if (vertex() || !edges.scales()) return;
    // The start plus a multiple of the direction.
    view_.emplace(edges.edge_view(feature.index));
    const DoubleDouble length_squared = dot(direction(), direction());
    length_squared_ = length_squared.high;
    if (maximum() >= kShortestDirection) multiple_ = dot(direction(), view_->to_center) / length_squared;
  }

  /// Returns the coordinate as the nearest double; zero as +0.
  [[nodiscard]] double coordinate(int axis) const {
    const bool moved = edges_.lifts(axis);
    if (vertex() && !moved) return edges_.given_vertex(feature_.index, axis) + 0.0;  // -0 becomes +0
    if (const auto result = in_doubles(axis, moved)) {
      edges_.counts().count(Stage::DoubleDouble);
      return *result;
    }
    edges_.counts().count(Stage::BigInteger);
    return edges_.bigint_point(feature_, axis);
  }

 private:
  using EdgeView = std::remove_cvref_t<decltype(std::declval<const Edges&>().edge_view(0))>;

  [[nodiscard]] bool vertex() const { return feature_.kind == Feature::Kind::Vertex; }
  [[nodiscard]] bool face() const { return feature_.kind == Feature::Kind::Face; }
  [[nodiscard]] const Vector3<DoubleDouble>& direction() const { return face() ? view_->normal : view_->edge; }
  [[nodiscard]] double maximum() const { return face() ? view_->maxima.normal : view_->maxima.edge; }

  [[nodiscard]] std::optional<double> in_doubles(int axis, bool moved) const {
    if (!edges_.scales()) return std::nullopt;
    const int exponent = edges_.exponent();
    DoubleDouble start = face() ? edges_.center(axis) : edges_.vertex(feature_.index, axis);
    if (moved && !face()) start = start + edges_.lift(feature_.index);
    const double lift_error = moved ? 2 * bounds::kLift : 0;
    if (vertex()) return rounded({start, lift_error + 2 * bounds::kDoubleDoubleUnit * std::abs(start.high)}, exponent);
    if (maximum() < kShortestDirection) return std::nullopt;

    const DoubleDouble& along = direction()[axis];
    if (!moved && along.high == 0) {  // exact
      if (!face() || view_->no_normal(axis)) return rounded({start, 0}, exponent);
      if (EdgeView::kNormalError == 0) return std::nullopt;  // exact: scaling may have made it zero
    }
    const DoubleDouble step = multiple_ * along, value = face() ? start - step : start + step;
    if (!(std::abs(value.high) >= kSmallestResult)) return std::nullopt;
    const double share =
        std::abs(along.high) / length_squared_ + (face() ? EdgeView::kNormalError / std::sqrt(length_squared_) : 0);
    const double error = bounds::kClosest * (view_->maxima.to_center * maximum() * share) +
                         bounds::kClosest * (view_->lifted ? view_->maxima.edge : 0) +
                         2 * bounds::kDoubleDoubleUnit * (std::abs(start.high) + std::abs(value.high)) + lift_error;
    return rounded({value, error}, exponent);
  }

  const Edges& edges_;
  const Feature feature_;
  std::optional<EdgeView> view_;  // of an edge or the face, if the doubles hold it
  DoubleDouble multiple_;
  double length_squared_ = 0;
};

/// Returns the distance of the ball's centre from the feature's plane, line or point, as the nearest double.
template <class Edges>
double distance(const Edges& edges, const Feature& feature) {
  const auto in_doubles = [&]() -> std::optional<double> {
    if (!edges.scales()) return std::nullopt;
    const auto& view = edges.edge_view(feature.index);
    const auto enclosed = [&]() -> Enclosed {
      if (feature.kind == Feature::Kind::Vertex) {
        const DoubleDouble value = sqrt(dot(view.to_center, view.to_center));
        return {value, bounds::kClosest * (value.high + (view.lifted ? view.maxima.to_center : 0))};
      }
      const bool face = feature.kind == Feature::Kind::Face;
      const Vector3<DoubleDouble>& direction = face ? view.normal : view.edge;
      const double maximum = face ? view.maxima.normal : view.maxima.edge;
      if (maximum < kShortestDirection) return {};
      const DoubleDouble length = sqrt(dot(direction, direction)), height = dot(view.normal, view.to_center);
      const auto moment = cross(view.to_center, view.edge);
      const DoubleDouble product = face ? (height.high < 0 ? -height : height) : sqrt(dot(moment, moment));
      const DoubleDouble value = product / length;
      return {value, bounds::kClosest * (view.maxima.to_center * maximum / length.high + value.high)};
    }();
    if (is_zero(view.to_center) && !view.lifted) return 0;
    if (!(enclosed.value.high >= kSmallestResult)) return std::nullopt;
    return rounded(enclosed, edges.exponent());
  };
  if (const auto result = in_doubles()) {
    edges.counts().count(Stage::DoubleDouble);
    return *result;
  }
  edges.counts().count(Stage::BigInteger);
  return edges.bigint_distance(feature);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "robust/filtered/detail/polygon/exact_edges.h"

/// The closest point, the distance, the contact normal and the depth, correctly rounded: in double-doubles with a
/// rounding test, and in integers of any size if that is ambiguous.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

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

/// Returns the double nearest to the number in the caller's unit of length, if every number within the error rounds to
/// it, as a normal double or as an exact zero. `Edges` as below.
template <class Edges>
TOUCHSTONE_INLINE std::optional<double> rounded(const Enclosed& number, const Edges& edges) {
  const double high = number.value.high, low = number.value.low;
  if (high == 0 && low == 0 && number.error == 0) return 0.0;            // exact
  assert(number.error == 0 || number.error >= 0x1p-52 * std::abs(low));  // exact
  if (!surely_nearest(high, low, number.error)) return std::nullopt;
  const double result = edges.unscaled(high);
  if (!(std::abs(result) >= 0x1p-1020 && std::abs(result) < 0x1p1023)) return std::nullopt;
  return result;
}

// Below these sizes squares or steps may underflow, and the error bounds do not hold. Above them the effect of
// underflow on a step and on the components of its direction is smaller than the slack in the two units of the result.
inline constexpr double kShortestDirection = 0x1p-100, kSmallestResult = 0x1p-300;

/// Computes the feature's point closest to the centre, and their distance: that from the feature's plane, line or
/// point. `Edges` are those of a prepared polygon (ExactEdges) or of a triangle (ExactTriangle).
///
/// Requires that each component of a direction has a small relative error, except for lifts and kNormalError: then a
/// coordinate that the step hardly changes has an error much smaller than the step. Requires during its lifetime that
/// no other edge of `edges` is looked at.
template <class Edges>
class ClosestPointOnFeature {
 public:
  ClosestPointOnFeature(const Edges& edges, const Feature& feature) : edges_(edges), feature_(feature) {
    if (!edges.scales()) return;
    view_ = &edges.edge_view(feature.index);
    if (vertex() || maximum() < kShortestDirection) return;
    // The point is the start plus a multiple of the direction.
    per_square_ = face() ? view_->per_normal_square() : reciprocal(dot(direction(), direction()));
    along_ = dot(direction(), view_->to_center);
    multiple_ = along_ * per_square_;
  }

  /// Returns the coordinate as the nearest double; zero as +0.
  [[nodiscard]] double coordinate(int axis) const {
    const bool moved = edges_.lifts(axis);
    if (vertex() && !moved) return edges_.given_vertex(feature_.index, axis) + 0.0;  // -0 becomes +0
    if (const auto result = coordinate_in_doubles(axis, moved)) {
      edges_.counts().count(Stage::DoubleDouble);
      return *result;
    }
    if (const auto result = coordinate_of_tie(axis)) {
      edges_.counts().count(Stage::FixedInteger);
      return *result;
    }
    edges_.counts().count(Stage::BigInteger);
    return edges_.bigint_point(feature_, axis);
  }

  /// Returns the distance as the nearest double.
  [[nodiscard]] double distance() const {
    if (const auto result = distance_in_doubles()) {
      edges_.counts().count(Stage::DoubleDouble);
      return *result;
    }
    edges_.counts().count(Stage::BigInteger);
    return edges_.bigint_distance(feature_);
  }

  /// Returns the contact normal, each component as the nearest double; zero as +0.
  [[nodiscard]] Eigen::Vector3d contact_normal() const {
    double normal[3];
    if (edges_.scales() && (face() || coincides() ? find_face_normal(normal) : find_normal_off_face(normal))) {
      edges_.counts().count(Stage::DoubleDouble);
      return {normal[0], normal[1], normal[2]};
    }
    edges_.counts().count(Stage::BigInteger);
    return edges_.bigint_normal(feature_);
  }

  /// Returns the radius less the distance as the nearest double; zero as +0.
  [[nodiscard]] double depth() const {
    if (const auto result = depth_in_doubles()) {
      edges_.counts().count(Stage::DoubleDouble);
      return *result;
    }
    edges_.counts().count(Stage::BigInteger);
    return edges_.bigint_depth(feature_);
  }

 private:
  using EdgeView = std::remove_cvref_t<decltype(std::declval<const Edges&>().edge_view(0))>;

  [[nodiscard]] bool vertex() const { return feature_.kind == Feature::Kind::Vertex; }
  [[nodiscard]] bool face() const { return feature_.kind == Feature::Kind::Face; }
  [[nodiscard]] const Vector3<DoubleDouble>& direction() const { return face() ? view_->normal : view_->edge; }
  [[nodiscard]] double maximum() const { return face() ? view_->maxima.normal : view_->maxima.edge; }

  [[nodiscard]] std::optional<double> coordinate_in_doubles(int axis, bool moved) const {
    if (!edges_.scales()) return std::nullopt;
    DoubleDouble start = face() ? edges_.center(axis) : edges_.vertex(feature_.index, axis);
    if (moved && !face()) start = start + edges_.lift(feature_.index);
    const double lift_error = moved ? 2 * bounds::kLift : 0;
    if (vertex()) return rounded({start, lift_error + 2 * bounds::kDoubleDoubleUnit * std::abs(start.high)}, edges_);
    if (maximum() < kShortestDirection) return std::nullopt;

    const DoubleDouble& component = direction()[axis];
    if (!moved && component.high == 0) {  // exact
      if (!face() || view_->no_normal(axis)) return rounded({start, 0}, edges_);
      if constexpr (EdgeView::kNormalError == 0) return std::nullopt;  // exact: scaling may have made it zero
    }
    const DoubleDouble step = multiple_ * component, value = face() ? start - step : start + step;
    if (!(std::abs(value.high) >= kSmallestResult)) return std::nullopt;
    double share = std::abs(component.high) * per_square_.high;
    if constexpr (EdgeView::kNormalError != 0)
      if (face()) share += EdgeView::kNormalError * std::sqrt(per_square_.high);
    const double error = bounds::kClosest * (view_->maxima.to_center * maximum() * share) +
                         bounds::kClosest * (view_->lifted ? view_->maxima.edge : 0) +
                         2 * bounds::kDoubleDoubleUnit * (std::abs(start.high) + std::abs(value.high)) + lift_error;
    return rounded({value, error}, edges_);
  }

  /// Returns the even one of two doubles if integers show that the coordinate of a point on an edge is exactly halfway
  /// between them, as often on edges at 45 degrees. Then no bound of errors can tell which is nearer.
  [[nodiscard]] std::optional<double> coordinate_of_tie(int axis) const {
    if (!edges_.scales() || vertex() || face() || view_->lifted || maximum() < kShortestDirection) return std::nullopt;
    const DoubleDouble start = edges_.vertex(feature_.index, axis), value = start + multiple_ * direction()[axis];
    const double beside = std::nextafter(value.high, value.low < 0 ? -HUGE_VAL : HUGE_VAL);
    const double half = (beside - value.high) / 2;  // exact
    const DoubleDouble step = two_difference(value.high, start.high), rest = two_sum(step.low, half);
    if (rest.low != 0) return std::nullopt;  // exact
    if (!is_step_along<62>(view_->to_center, view_->edge, {step.high, rest.high}, axis)) return std::nullopt;
    return rounded({{value.high + half, 0}, 0}, edges_);  // to even
  }

  [[nodiscard]] std::optional<double> distance_in_doubles() const {
    if (!edges_.scales()) return std::nullopt;
    if (is_zero(view_->to_center) && !view_->lifted) return 0;
    const Enclosed& enclosed = enclosed_distance();
    if (!(enclosed.value.high >= kSmallestResult)) return std::nullopt;
    return rounded(enclosed, edges_);
  }

  [[nodiscard]] std::optional<double> depth_in_doubles() const {
    if (!edges_.scales() || !edges_.radius_scales()) return std::nullopt;
    const DoubleDouble radius = edges_.radius();
    if (coincides()) return rounded({radius, 0}, edges_);
    const auto& [distance, error] = enclosed_distance();
    if (!(distance.high >= kSmallestResult)) return std::nullopt;
    const DoubleDouble value = radius - distance;
    return rounded({value, error + 2 * bounds::kDoubleDoubleUnit * std::abs(value.high)}, edges_);
  }

  /// Writes the face's normal towards the centre; returns whether every component surely is the nearest double.
  ///
  /// N is known to kNormalError kClosest m_N / 64 in each component, and 1 / N.N to kPerSquare units of itself and to
  /// the error that this leaves.
  [[nodiscard]] bool find_face_normal(double (&normal)[3]) const {
    if (view_->maxima.normal < kShortestDirection) return false;
    const int side = face() ? estimate(along_, bound<SignKind::Front>(view_->maxima)).sign() : 1;
    if (side == 0) return false;
    const DoubleDouble per_length = sqrt(face() ? per_square_ : view_->per_normal_square());
    const double error_of_normal = EdgeView::kNormalError * view_->maxima.normal * per_length.high;
    for (int axis = 0; axis < 3; ++axis) {
      normal[axis] = 0;
      if (view_->no_normal(axis)) continue;
      const DoubleDouble component = view_->normal[axis] * per_length;
      if (!is_sure(component, bounds::kClosest * (error_of_normal + std::abs(component.high)))) return false;
      normal[axis] = side > 0 ? component.high : -component.high;
    }
    return true;
  }
  /// Writes (c - p) / d for the closest point p; returns whether every component surely is the nearest double.
  ///
  /// If c - p is known to e and d to e', the quotient is known to 4/3 (e + |(c - p) / d| e') / d and its rounding,
  /// provided that e' <= d / 4; if not, nothing rounds surely.
  [[nodiscard]] bool find_normal_off_face(double (&normal)[3]) const {
    const Enclosed& distance = enclosed_distance();
    if (!(distance.value.high >= kSmallestResult)) return false;
    const DoubleDouble per_distance = reciprocal(distance.value);
    for (int axis = 0; axis < 3; ++axis) {
      normal[axis] = 0;
      const Enclosed away = vertex() ? away_from_vertex(axis) : away_from_edge(axis);
      if (away.error == 0 && away.value.high == 0) continue;  // exact
      const DoubleDouble component = away.value * per_distance;
      const double error = 2 * (away.error + std::abs(component.high) * distance.error) * per_distance.high;
      if (!is_sure(component, error)) return false;
      normal[axis] = component.high;
    }
    return true;
  }
  [[nodiscard]] static bool is_sure(const DoubleDouble& component, double error) {
    return std::abs(component.high) >= kSmallestResult && surely_nearest(component.high, component.low, error);
  }
  /// @{
  /// Returns a component of c - p, where p lies on a vertex or an edge.
  [[nodiscard]] Enclosed away_from_vertex(int axis) const {
    return {view_->to_center[axis], view_->lifted ? bounds::kClosest * view_->maxima.to_center : 0};
  }
  [[nodiscard]] Enclosed away_from_edge(int axis) const {
    const Enclosed from_start = away_from_vertex(axis);
    const DoubleDouble& along = view_->edge[axis];
    if (!view_->lifted && along.high == 0) return from_start;  // exact
    const DoubleDouble value = from_start.value - multiple_ * along;
    if (!view_->lifted && (is_parallel_to(axis) || (std::abs(value.high) <= 0x1p-80 * view_->maxima.to_center &&
                                                    zero_across(view_->to_center, view_->edge, axis))))
      return {{}, 0};
    if (!(std::abs(value.high) >= kSmallestResult)) return {value, HUGE_VAL};  // the bound may underflow
    const double of_step = view_->maxima.to_center * maximum() * (std::abs(along.high) * per_square_.high);
    return {value, from_start.error + bounds::kClosest * (of_step + (view_->lifted ? view_->maxima.edge : 0)) +
                       2 * bounds::kDoubleDoubleUnit * (std::abs(from_start.value.high) + std::abs(value.high))};
  }
  /// @}
  [[nodiscard]] bool is_parallel_to(int axis) const {
    return view_->edge[(axis + 1) % 3].high == 0 && view_->edge[(axis + 2) % 3].high == 0;  // exact
  }

  /// Returns whether the centre is the vertex that is the closest point.
  [[nodiscard]] bool coincides() const { return is_zero(view_->to_center) && !view_->lifted; }
  [[nodiscard]] const Enclosed& enclosed_distance() const {
    if (!distance_) distance_.emplace(computed_distance());
    return *distance_;
  }
  [[nodiscard]] Enclosed computed_distance() const {
    if (vertex()) {
      const DoubleDouble value = sqrt(dot(view_->to_center, view_->to_center));
      return {value, bounds::kClosest * (value.high + (view_->lifted ? view_->maxima.to_center : 0))};
    }
    if (maximum() < kShortestDirection) return {};
    const DoubleDouble value = sqrt((face() ? along_ * along_ : squared_moment()) * per_square_);
    const double per_length = std::sqrt(per_square_.high);
    return {value, bounds::kClosest * (view_->maxima.to_center * maximum() * per_length + value.high)};
  }
  [[nodiscard]] DoubleDouble squared_moment() const {
    const auto moment = cross(view_->to_center, view_->edge);
    return dot(moment, moment);
  }

  const Edges& edges_;
  const Feature feature_;
  const EdgeView* view_ = nullptr;  // if the doubles hold it
  // 1 / D.D, D.to_center and their product, for the direction D of an edge or the face.
  DoubleDouble per_square_, along_, multiple_;
  mutable std::optional<Enclosed> distance_;
};

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

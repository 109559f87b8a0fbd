// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/filtered/polygon_questions.h"

/// The closest point and the distance, correctly rounded: double-doubles with a rounding test, unlimited integers where
/// that is ambiguous.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Numerators are known to 24 units of their maxima, squared lengths to 40 units, a unit being 2^-103: in all well below
/// 2^-94 of what the errors below multiply it with.
inline constexpr double kRelative = 0x1p-94;

/// A double-double and how far it may be from what it stands for.
struct Enclosed {
  DoubleDouble value;
  double error;
};

/// The double nearest to the number times 2^exponent, if every number within the error rounds to it, as a normal
/// double or as an exact zero.
inline std::optional<double> rounded(const Enclosed& number, int exponent) {
  const double high = number.value.high, low = number.value.low;
  if (high == 0 && low == 0 && number.error == 0) return 0.0;  // exact
  const double wide = number.error * 2;  // the sums below are rounded, too
  if (high + (low + wide) != high || high + (low - wide) != high) return std::nullopt;  // compared as rounded
  const double result = std::ldexp(high, exponent);
  if (!(std::abs(result) >= 0x1p-1020 && std::abs(result) < 0x1p1023)) return std::nullopt;
  return result;
}

template <class Counts>
double PolygonQuestion<Counts>::point(const Feature& feature, int axis) {
  const ExactEdges<Counts>& edges = exact();
  const auto in_doubles = [&]() -> std::optional<double> {
    if (!edges.scales()) return std::nullopt;
    const auto q = edges.seen(feature.index);
    // Lifted vertices are known to 2^-99.
    const bool moved = q.lifted && axis == parts_.unlimited.dropped_axis();
    const double lift_error = moved ? 0x1p-98 : 0;
    if (feature.kind == Feature::Kind::Vertex && !moved) return parts_.polygon.vertex(feature.index)[axis];
    const DoubleDouble start = DoubleDouble(edges.center(axis)) - q.from[axis];  // exact but for a lift
    if (feature.kind == Feature::Kind::Vertex) return rounded({start, lift_error}, parts_.frame->exponent);

    // origin - (numerator / denominator) direction, with an error of the numerator of a few units of its maxima.
    const bool face = feature.kind == Feature::Kind::Face;
    const Vector3<DoubleDouble>& direction = face ? q.polygon.normal : q.edge;
    const double maximum = face ? q.maxima.normal : q.maxima.edge;
    const DoubleDouble length_squared = dot(direction, direction);
    const DoubleDouble share = dot(direction, q.from) / length_squared;
    const DoubleDouble step = share * direction[axis];
    const DoubleDouble value = face ? DoubleDouble(edges.center(axis)) - step : start + step;
    const double error =
        kRelative * (q.maxima.from * maximum * std::abs(direction[axis].high) / length_squared.high) +
        kRelative * (q.lifted ? q.maxima.edge : 0) + 0x1p-102 * (std::abs(start.high) + std::abs(value.high)) + lift_error;
    return rounded({value, error}, parts_.frame->exponent);
  };
  if (const auto result = in_doubles()) {
    counts_.count(Stage::DoubleDouble);
    return *result;
  }
  counts_.count(Stage::Unlimited);
  return parts_.unlimited.point(ball_, feature, axis);
}

template <class Counts>
double PolygonQuestion<Counts>::distance(const Feature& feature) {
  const ExactEdges<Counts>& edges = exact();
  const auto in_doubles = [&]() -> std::optional<double> {
    if (!edges.scales()) return std::nullopt;
    const auto q = edges.seen(feature.index);
    if (feature.kind == Feature::Kind::Vertex) {
      const DoubleDouble value = sqrt(dot(q.from, q.from));
      return rounded({value, kRelative * value.high + (q.lifted ? kRelative * q.maxima.from : 0)},
                     parts_.frame->exponent);
    }
    const bool face = feature.kind == Feature::Kind::Face;
    const Vector3<DoubleDouble>& direction = face ? q.polygon.normal : q.edge;
    const DoubleDouble length = sqrt(dot(direction, direction));
    const auto moment = cross(q.from, q.edge);
    const DoubleDouble height = dot(q.polygon.normal, q.from);
    const DoubleDouble value = (face ? DoubleDouble(height.high < 0 ? -height : height) : sqrt(dot(moment, moment))) / length;
    const double maximum = face ? q.maxima.normal : q.maxima.edge;
    const double error = kRelative * (q.maxima.from * maximum / length.high + value.high);
    return rounded({value, error}, parts_.frame->exponent);
  };
  if (const auto result = in_doubles()) {
    counts_.count(Stage::DoubleDouble);
    return *result;
  }
  counts_.count(Stage::Unlimited);
  return parts_.unlimited.distance(ball_, feature);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>

#include "robust/filtered/exact_edges.h"

/// The closest point and the distance, correctly rounded: double-doubles with a rounding test, unlimited integers where
/// that is ambiguous.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

/// Numerators are known to 24 units of their maxima, squared lengths to 40 units, a unit being 2^-103: in all well
/// below 2^-94, 512 units, of what the errors below multiply it with.
///
/// The normal N of a triangle is known to 4.1 units of m_N in each component, so to 7.1 m_N as a vector: the projection
/// of `from`, at most sqrt(3) m_w long, onto its direction moves by 2 sqrt(3) m_w 7.1 m_N / |N| at most, 25 units of
/// m_w m_N / |N|. Since |N| <= sqrt(3) m_N, the 24, the 40 and the roundings of the quotient are 200 units of it.
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
  const double wide = number.error * 2;                        // the sums below are rounded, too
  if (high + (low + wide) != high || high + (low - wide) != high) return std::nullopt;  // compared as rounded
  const double result = std::ldexp(high, exponent);
  if (!(std::abs(result) >= 0x1p-1020 && std::abs(result) < 0x1p1023)) return std::nullopt;
  return result;
}

// Below these sizes squares or steps may underflow, and what is said of errors does not hold.
inline constexpr double kShortestDirection = 0x1p-100, kSmallestResult = 0x1p-300;

/// A coordinate of the feature's point that is closest to the centre, as the nearest double. `edges` are those of a
/// prepared polygon (ExactEdges) or of a triangle (SeenTriangle).
template <class Edges>
double closest_point(const Edges& edges, const Feature& feature, int axis) {
  const bool vertex = feature.kind == Feature::Kind::Vertex, face = feature.kind == Feature::Kind::Face;
  const bool moved = edges.lifts(axis);
  if (vertex && !moved) return edges.given_vertex(feature.index, axis);

  const auto in_doubles = [&]() -> std::optional<double> {
    if (!edges.scales()) return std::nullopt;
    const int exponent = edges.exponent();
    DoubleDouble start = face ? edges.center(axis) : edges.vertex(feature.index, axis);
    if (moved && !face) start = start + edges.lift(feature.index);
    const double lift_error = moved ? 0x1p-98 : 0;  // lifts are known to 2^-99
    if (vertex) return rounded({start, lift_error + 0x1p-102 * std::abs(start.high)}, exponent);

    // The start and a share of a direction, the share a quotient with an error of a few units of its maxima.
    const auto seen = edges.seen(feature.index);
    using Seen = decltype(seen);
    const Vector3<DoubleDouble>& direction = face ? seen.normal : seen.edge;
    const double maximum = face ? seen.maxima.normal : seen.maxima.edge;
    if (maximum < kShortestDirection) return std::nullopt;
    if (!moved && direction[axis].high == 0) {  // exact
      if (!face || seen.no_normal(axis)) return rounded({start, 0}, exponent);
      if (Seen::kNormalError == 0) return std::nullopt;  // exact: scaling may have made it zero
    }
    const DoubleDouble length_squared = dot(direction, direction);
    const DoubleDouble step = dot(direction, seen.from) / length_squared * direction[axis];
    const DoubleDouble value = face ? start - step : start + step;
    if (!(std::abs(value.high) >= kSmallestResult)) return std::nullopt;
    const double share = std::abs(direction[axis].high) / length_squared.high +
                         (face ? Seen::kNormalError / std::sqrt(length_squared.high) : 0);
    const double error = kRelative * (seen.maxima.from * maximum * share) +
                         kRelative * (seen.lifted ? seen.maxima.edge : 0) +
                         0x1p-102 * (std::abs(start.high) + std::abs(value.high)) + lift_error;
    return rounded({value, error}, exponent);
  };
  if (const auto result = in_doubles()) {
    edges.counts().count(Stage::DoubleDouble);
    return *result;
  }
  edges.counts().count(Stage::Unlimited);
  return edges.unlimited_point(feature, axis);
}

/// The distance of the ball's centre from the feature's plane, line or point, as the nearest double.
template <class Edges>
double distance(const Edges& edges, const Feature& feature) {
  const auto in_doubles = [&]() -> std::optional<double> {
    if (!edges.scales()) return std::nullopt;
    const auto seen = edges.seen(feature.index);
    const auto enclosed = [&]() -> Enclosed {
      if (feature.kind == Feature::Kind::Vertex) {
        const DoubleDouble value = sqrt(dot(seen.from, seen.from));
        return {value, kRelative * (value.high + (seen.lifted ? seen.maxima.from : 0))};
      }
      const bool face = feature.kind == Feature::Kind::Face;
      const Vector3<DoubleDouble>& direction = face ? seen.normal : seen.edge;
      const double maximum = face ? seen.maxima.normal : seen.maxima.edge;
      if (maximum < kShortestDirection) return {};
      const DoubleDouble length = sqrt(dot(direction, direction)), height = dot(seen.normal, seen.from);
      const auto moment = cross(seen.from, seen.edge);
      const DoubleDouble product = face ? (height.high < 0 ? -height : height) : sqrt(dot(moment, moment));
      const DoubleDouble value = product / length;
      return {value, kRelative * (seen.maxima.from * maximum / length.high + value.high)};
    }();
    if (is_zero(seen.from) && !seen.lifted) return 0;
    if (!(enclosed.value.high >= kSmallestResult)) return std::nullopt;
    return rounded(enclosed, edges.exponent());
  };
  if (const auto result = in_doubles()) {
    edges.counts().count(Stage::DoubleDouble);
    return *result;
  }
  edges.counts().count(Stage::Unlimited);
  return edges.unlimited_distance(feature);
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

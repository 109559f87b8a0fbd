// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace touchstone::workloads {

/// Returns the rank of a double in ascending order: 0 (and -0) has 0, the smallest subnormal 1, its negative -1.
/// Requires that it is not a NaN.
[[nodiscard]] constexpr std::int64_t ordinal(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

/// Returns the double of that rank.
///  (1) from_ordinal(ordinal(x)) == x.
[[nodiscard]] constexpr double from_ordinal(std::int64_t ordinal) {
  return std::bit_cast<double>(ordinal >= 0 ? ordinal : std::numeric_limits<std::int64_t>::min() - ordinal);
}

/// Returns the number of doubles by which `upper` exceeds `lower`, negative if it lies below. Saturates: across zero
/// the number may not fit.
[[nodiscard]] constexpr std::int64_t doubles_between(double lower, double upper) {
  std::int64_t difference = 0;
  if (!__builtin_sub_overflow(ordinal(upper), ordinal(lower), &difference)) return difference;
  return upper > lower ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

/// Returns the double that lies `steps` doubles above a finite one (below, if negative).
[[nodiscard]] constexpr double move_by_doubles(double value, std::int64_t steps) {
  return from_ordinal(ordinal(value) + steps);
}

/// Moves a radius likewise, but not below 0 or beyond the largest double.
[[nodiscard]] constexpr double move_radius_by_doubles(double radius, std::int64_t steps) {
  constexpr std::int64_t kLast = ordinal(std::numeric_limits<double>::max());
  return from_ordinal(std::clamp<std::int64_t>(ordinal(radius) + steps, 0, kLast));
}

/// Returns the finite double nearest to x; an overflow becomes the largest double of its sign. Requires that x is not a
/// NaN.
[[nodiscard]] inline double finite(double x) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::clamp(x, -kLargest, kLargest);
}

/// The same for each coordinate.
[[nodiscard]] inline Eigen::Vector3d finite(const Eigen::Vector3d& point) {
  return {finite(point.x()), finite(point.y()), finite(point.z())};
}

}  // namespace touchstone::workloads

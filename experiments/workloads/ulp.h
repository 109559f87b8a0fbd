// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace touchstone::workloads {

/// The number of a double when all are counted in ascending order: 0 is 0 (and so is -0), the smallest subnormal 1, its
/// negative -1. Requires no NaN.
[[nodiscard]] constexpr std::int64_t ordinal(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

/// The double of that ordinal. (1) from_ordinal(ordinal(x)) == x.
[[nodiscard]] constexpr double from_ordinal(std::int64_t ordinal) {
  return std::bit_cast<double>(ordinal >= 0 ? ordinal : std::numeric_limits<std::int64_t>::min() - ordinal);
}

/// How many doubles `upper` lies above `lower`, negative where it lies below. Across zero that may be more than there
/// are numbers for: then it is the last of them.
[[nodiscard]] constexpr std::int64_t doubles_between(double lower, double upper) {
  std::int64_t difference = 0;
  if (!__builtin_sub_overflow(ordinal(upper), ordinal(lower), &difference)) return difference;
  return upper > lower ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

/// The double that lies `steps` doubles above (below, if negative) a finite one.
[[nodiscard]] constexpr double move_by_doubles(double value, std::int64_t steps) {
  return from_ordinal(ordinal(value) + steps);
}

/// A radius moved likewise, but never below 0 or beyond the largest double.
[[nodiscard]] constexpr double move_radius_by_doubles(double radius, std::int64_t steps) {
  constexpr std::int64_t kLast = ordinal(std::numeric_limits<double>::max());
  return from_ordinal(std::clamp<std::int64_t>(ordinal(radius) + steps, 0, kLast));
}

}  // namespace touchstone::workloads

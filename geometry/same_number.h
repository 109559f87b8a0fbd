// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>

namespace touchstone {

/// Returns whether two doubles are the same number: 0 equals -0, and a NaN equals nothing.
///
/// Compares bits: operator == would take any two subnormal numbers for equal where the caller's floating-point unit
/// treats them as zeros.
[[nodiscard]] constexpr bool same_number(double a, double b) {
  constexpr std::uint64_t kInfinity = std::uint64_t{0x7ff} << 52;
  const auto bits_a = std::bit_cast<std::uint64_t>(a), bits_b = std::bit_cast<std::uint64_t>(b);
  const std::uint64_t magnitudes = (bits_a | bits_b) << 1;  // 0 for two zeros
  return magnitudes == 0 || (bits_a == bits_b && (bits_a << 1) >> 1 <= kInfinity);
}

/// Returns whether two points have the same coordinates, compared by `same_number`.
[[nodiscard]] inline bool same_point(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return same_number(p.x(), q.x()) && same_number(p.y(), q.y()) && same_number(p.z(), q.z());
}

}  // namespace touchstone

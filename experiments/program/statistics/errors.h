// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

namespace touchstone::statistics {

/// Returns the unit in the last place of a double: from its magnitude to the next larger one; the smallest subnormal
/// for 0. Requires a finite value.
[[nodiscard]] double unit_in_last_place(double value);

/// Returns the difference of a computed number from the correctly rounded exact one, in units in the last place of
/// the latter. Infinite if the computed one is not finite. 0 means correctly rounded, that is, at most half a unit from
/// the true number.
[[nodiscard]] double number_error(double computed, double exact);

/// Returns the same for points: the largest difference of a coordinate, in units in the last place of the exact point's
/// largest coordinate (units of a coordinate near 0 would measure the choice of the origin).
[[nodiscard]] double point_error(const Eigen::Vector3d& computed, const Eigen::Vector3d& exact);

/// A distribution of numbers from 0 to infinity, for quantiles, in memory that does not grow with the count. Each
/// number is cut to seven significant bits, which keeps zero, infinity and whole numbers up to 128 exact.
class Distribution {
 public:
  /// Adds a number, which must not be negative or NaN.
  void add(double number);
  /// Adds all numbers of `other`. The order of summation does not affect the result.
  Distribution& operator+=(const Distribution& other);

  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::uint64_t zeros() const;
  [[nodiscard]] std::uint64_t infinite() const;
  /// Returns the smallest number, as cut, such that at least the given share of the numbers does not exceed it. It is
  /// too small by less than 1/64 of its value; for shares from 1 on it is exact. Requires at least one number. Cost:
  /// linear in the number of distinct cut values.
  [[nodiscard]] double quantile(double share) const;
  /// Returns the largest number, exactly; 0 without numbers.
  [[nodiscard]] double largest() const { return largest_; }

  auto members() { return std::tie(counts_, largest_); }
  friend bool operator==(const Distribution&, const Distribution&) = default;

 private:
  std::map<std::uint32_t, std::uint64_t> counts_;  ///< by the leading bits of the doubles, which ascend with them
  double largest_ = 0;
};

}  // namespace touchstone::statistics

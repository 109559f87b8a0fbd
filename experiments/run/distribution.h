// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

namespace touchstone::statistics {

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

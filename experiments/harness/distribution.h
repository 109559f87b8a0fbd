// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>

namespace touchstone::statistics {

/// Many numbers from 0 to infinity, of which quantiles are asked, in memory that does not grow with their count: each
/// is cut to seven significant bits, which keeps zero, infinity and whole numbers up to 128 as they are.
class Distribution {
 public:
  /// Requires a number that is neither negative nor NaN.
  void add(double number);
  /// Sums do not depend on their order.
  Distribution& operator+=(const Distribution& other);

  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::uint64_t zeros() const;
  [[nodiscard]] std::uint64_t infinite() const;
  /// The smallest number that at least this share does not exceed, as it was cut: short of it by less than 1/64 of it;
  /// from share 1 on exact. Requires a number. Cost: linear in the distinct ones.
  [[nodiscard]] double quantile(double share) const;
  /// Exact; 0 where there is no number.
  [[nodiscard]] double largest() const { return largest_; }

  auto members() { return std::tie(counts_, largest_); }
  friend bool operator==(const Distribution&, const Distribution&) = default;

 private:
  std::map<std::uint32_t, std::uint64_t> counts_;  ///< by the leading bits of the doubles, which ascend with them
  double largest_ = 0;
};

}  // namespace touchstone::statistics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace touchstone::near_edge {

/// A ball for which the truth used by a study differs from `exact`: a defect of this program, not of a method.
struct Disagreement {
  std::uint64_t n;  ///< of the sample
  std::uint64_t stratum;
  std::string line;  ///< one line of JSON: the case in the contract's form, with what `exact` says expected

  auto members() { return std::tie(n, stratum, line); }
  friend bool operator==(const Disagreement&, const Disagreement&) = default;
};

/// Counts all disagreements and keeps the first ones; sums do not depend on their order.
class Disagreements {
 public:
  static constexpr std::size_t kMostKept = 1000;

  /// Adds all disagreements of one sample, in their order.
  void add(std::vector<Disagreement> found);
  Disagreements& operator+=(const Disagreements& other);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// Returns the first ones by n, then by stratum.
  [[nodiscard]] const std::vector<Disagreement>& kept() const { return kept_; }

  auto members() { return std::tie(count_, kept_); }
  friend bool operator==(const Disagreements&, const Disagreements&) = default;

 private:
  void keep_first();

  std::uint64_t count_ = 0;
  std::vector<Disagreement> kept_;
};

}  // namespace touchstone::near_edge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/threshold.h"

namespace touchstone::near_edge {

using cases::kTests;
using cases::Outcome;
using cases::Test;

struct Tally {
  std::uint64_t failures = 0, trials = 0;

  auto members() { return std::tie(failures, trials); }
  Tally& operator+=(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// The counts of one test of one method in some strata.
///
/// Samples are independent, and so are the trials at one offset; trials of one sample at different offsets are not. So
/// confidence limits apply to `samples` and to single offsets, not to `all`.
struct Summary {
  Tally samples;                             ///< a sample fails if it fails at any offset
  Tally all;                                 ///< every offset of every sample
  std::optional<std::int64_t> below, above;  ///< the lowest and the highest offset at which a failure was seen
};

/// Failures and trials by stratum, test, method (index in the list) and offset.
class Counts {
 public:
  Counts() = default;
  explicit Counts(std::size_t methods);

  /// Adds one sample, with `failed` for each offset.
  void add(std::size_t stratum, Test test, std::size_t method, const std::vector<bool>& failed);
  auto members() { return std::tie(tallies_); }

  [[nodiscard]] std::size_t methods() const { return methods_; }
  [[nodiscard]] const Tally& at(std::size_t stratum, Test test, std::size_t method, std::size_t offset) const;
  /// Returns the sum over these strata.
  [[nodiscard]] Summary summary(const std::vector<std::size_t>& strata, Test test, std::size_t method) const;

  friend bool operator==(const Counts&, const Counts&) = default;

 private:
  [[nodiscard]] std::size_t first(std::size_t stratum, Test test, std::size_t method) const;

  std::size_t methods_ = 0;
  std::vector<Tally> tallies_;  ///< one per offset, then one for the samples
};

}  // namespace touchstone::near_edge

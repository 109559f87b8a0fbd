// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "experiments/cases/comparison.h"
#include "experiments/cases/threshold.h"

namespace touchstone::near_edge {

using cases::kTests;
using cases::Outcome;
using cases::Test;

struct Tally {
  std::uint64_t failures = 0, trials = 0;

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
  /// Adds other counts; sums do not depend on their order. Requires the same methods.
  Counts& operator+=(const Counts& other);

  [[nodiscard]] std::size_t methods() const { return methods_; }
  [[nodiscard]] const Tally& at(std::size_t stratum, Test test, std::size_t method, std::size_t offset) const;
  /// Returns the sum over these strata.
  [[nodiscard]] Summary summary(const std::vector<std::size_t>& strata, Test test, std::size_t method) const;

  friend bool operator==(const Counts&, const Counts&) = default;
  // Throws nlohmann::json::exception where something is missing.
  friend void to_json(nlohmann::ordered_json& json, const Counts& counts);
  friend void from_json(const nlohmann::json& json, Counts& counts);

 private:
  [[nodiscard]] std::size_t first(std::size_t stratum, Test test, std::size_t method) const;

  std::size_t methods_ = 0;
  std::vector<Tally> tallies_;  ///< one per offset, then one for the samples
};

}  // namespace touchstone::near_edge

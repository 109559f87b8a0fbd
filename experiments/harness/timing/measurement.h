// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "experiments/harness/blocks.h"
#include "experiments/harness/timing/benchmark.h"

namespace touchstone::timing {

struct Quartiles {
  double minimum, lower, median, upper, maximum;
};

/// Between neighbours by their distance. Requires at least one value.
[[nodiscard]] Quartiles quartiles(std::vector<double> values);

struct Wrong {
  std::size_t count, of;
};

/// What one candidate did.
struct Measured {
  std::string name;
  std::size_t queries;              ///< asked in each repetition
  std::vector<double> nanoseconds;  ///< a query, of each repetition
  std::optional<Wrong> wrong;
  std::optional<Comparison> comparison;
  std::vector<double> ratios;  ///< to the base of the comparison, of each repetition
};

/// What a benchmark came to.
struct Result {
  std::string family, name, note, unit, pool;
  std::vector<Measured> candidates;
};

/// How long one candidate may take in one repetition of `bench`.
inline constexpr double kSecondsOfRepetition = 0.05;

/// Times every candidate in each repetition, in turn, each beginning once in so many repetitions; so drifts of the
/// machine's speed meet all alike, and a ratio is one of times that lie close together. (Google Benchmark would run one
/// candidate after the other.) Whoever would take more than `most_seconds` for a repetition is asked fewer queries,
/// the first ones. Fewer repetitions where stopped. Then counts wrong answers.
[[nodiscard]] Result measure(const std::string& family, const Benchmark& benchmark, unsigned repetitions,
                             const std::atomic<bool>& stop, const harness::Progress& progress,
                             double most_seconds = kSecondsOfRepetition);

/// The results of one pool together: the mean of the times of each candidate, repetition by repetition. Nothing where
/// there are fewer than two of the same candidates.
[[nodiscard]] std::optional<Result> pooled(const std::vector<Result>& results, const std::string& pool);

}  // namespace touchstone::timing

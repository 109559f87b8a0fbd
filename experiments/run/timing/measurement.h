// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/run/timing/benchmark.h"

namespace touchstone::timing {

struct Quartiles {
  double minimum, lower, median, upper, maximum;

  auto members() { return std::tie(minimum, lower, median, upper, maximum); }
};

/// Returns quartiles, interpolated linearly between neighbouring values. Requires at least one value.
[[nodiscard]] Quartiles quartiles(std::vector<double> values);

/// The largest quotient of the quartiles of a ratio that says anything.
inline constexpr double kMostSpread = 1.5;
/// Returns whether a ratio is too noisy to tell.
[[nodiscard]] bool too_noisy(const Quartiles& ratio);

struct Wrong {
  std::size_t count, of;
};

/// The measurements of one candidate.
struct Measured {
  std::string name;
  std::size_t queries;              ///< per repetition
  std::vector<double> nanoseconds;  ///< per query, for each repetition
  std::optional<Wrong> wrong;
  std::optional<Comparison> comparison;
  std::vector<double> ratios;  ///< to the base of the comparison, for each repetition
};

/// The result of a benchmark.
struct Result {
  std::string family, name, note, unit, pool;
  std::vector<Measured> candidates;
  std::vector<Share> shares{};
};

/// The time that one candidate may take in one repetition of `bench`.
inline constexpr double kSecondsOfRepetition = 0.05;

/// Times every candidate in each repetition, in turn; the first turn rotates among the candidates. Drifts of the speed
/// of the machine thus affect all candidates alike, and each ratio is one of times measured close together. (Google
/// Benchmark would run one candidate after the other.) A candidate that would take more than `most_seconds` for a
/// repetition gets fewer queries, the first ones. If stopped, there are fewer repetitions. Then counts wrong answers.
[[nodiscard]] Result measure(const std::string& family, const Benchmark& benchmark, unsigned repetitions,
                             const std::atomic<bool>& stop, const run::Progress& progress,
                             double most_seconds = kSecondsOfRepetition);

/// Combines the results of one pool: for each candidate, the mean of the times, repetition by repetition. Returns
/// nothing for fewer than two results with the same candidates.
[[nodiscard]] std::optional<Result> pooled(const std::vector<Result>& results, const std::string& pool);

}  // namespace touchstone::timing

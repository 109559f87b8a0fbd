// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/program/sweep.h"

namespace touchstone::timing {

/// The target for the ratio of two times: at most `ratio`, or at least.
struct Goal {
  double ratio;
  bool at_most = true;

  [[nodiscard]] bool met_by(double value) const { return at_most ? value <= ratio : value >= ratio; }
};

/// The candidate with whose time a candidate's time is compared, and the target.
struct Comparison {
  std::string base;
  std::optional<Goal> goal;
};

/// A candidate: one way of answering queries.
struct Candidate {
  std::string name;
  std::size_t queries;
  /// Answers the first n queries. Returns a sum of the answers, so that no answer is optimised away.
  std::function<std::uint64_t(std::size_t)> ask;
  /// Returns the number of wrong answers among the first n; not timed. Empty if there are no wrong answers. Answers are
  /// compared by == of their type, which need not be an answer of the contract.
  std::function<std::size_t(std::size_t)> count_wrong;
  /// Prepares for the first n queries; not timed. May be empty.
  std::function<void(std::size_t)> before;
  std::optional<Comparison> comparison;
  /// The maximal number of answers checked, for candidates whose check is costly.
  std::size_t most_checked = std::numeric_limits<std::size_t>::max();
};

/// A part of the queries of a benchmark, by name.
struct Share {
  std::string name;
  double share;
};

/// A benchmark: candidates that answer the same queries.
struct Benchmark {
  std::string name;            ///< within its family; empty if it is the only one
  std::string note;            ///< a description of the drawn queries
  std::string unit = "query";  ///< the name of one repeated item
  std::size_t checked = 0;     ///< the number of answers of each candidate that are compared with `exact`
  std::string pool;            ///< benchmarks of a family with the same non-empty pool are also reported together
  std::vector<Candidate> candidates;
  std::vector<Share> shares{};  ///< what is known of the queries beyond times
};

/// Returns the function that counts for how many of the first queries `holds`, asked of each in turn, is true.
template <class Holds>
[[nodiscard]] auto counting(const Holds& holds) {
  return [holds](std::size_t count) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i) found += holds(i) ? 1 : 0;
    return found;
  };
}

/// Returns a candidate that applies `ask` to a list of queries and compares the first answers with `truths`.
template <class Query, class Truth, class Ask>
Candidate candidate(std::string name, std::shared_ptr<const std::vector<Query>> queries,
                    std::shared_ptr<const std::vector<Truth>> truths, Ask ask,
                    std::optional<Comparison> comparison = std::nullopt) {
  const auto sum_of_answers = [queries, ask](std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += static_cast<std::uint64_t>(ask((*queries)[i]));
    return sum;
  };
  const auto is_wrong = [queries, truths, ask](std::size_t i) { return ask((*queries)[i]) != (*truths)[i]; };
  return {std::move(name), queries->size(), sum_of_answers, counting(is_wrong), {}, std::move(comparison)};
}

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
                             const std::atomic<bool>& stop, const program::Progress& progress,
                             double most_seconds = kSecondsOfRepetition);

/// Combines the results of one pool: for each candidate, the mean of the times, repetition by repetition. Returns
/// nothing for fewer than two results with the same candidates.
[[nodiscard]] std::optional<Result> pooled(const std::vector<Result>& results, const std::string& pool);

/// Returns the lines of one benchmark: a heading and a row for each candidate. Medians; quartiles in brackets.
[[nodiscard]] std::string table(const Result& result);
/// Returns the number of goals that were met, and the goals that were not.
[[nodiscard]] std::string goals(const std::vector<Result>& results);
/// Returns an explanation of the columns.
[[nodiscard]] std::string legend();

/// Returns all results: quartiles and every repetition of times and ratios, goals, wrong answers.
[[nodiscard]] nlohmann::ordered_json json(const std::vector<Result>& results);
/// Returns the vector extensions that the program was compiled for, and those of the processor.
[[nodiscard]] nlohmann::ordered_json processor_features();

}  // namespace touchstone::timing

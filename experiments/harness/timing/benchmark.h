// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::timing {

/// What the ratio of two times should be: at most (else at least) `ratio`.
struct Goal {
  double ratio;
  bool at_most = true;

  [[nodiscard]] bool met_by(double value) const { return at_most ? value <= ratio : value >= ratio; }
};

/// Against whom a candidate's time is held.
struct Comparison {
  std::string base;
  std::optional<Goal> goal;
};

/// One way of answering queries.
struct Candidate {
  std::string name;
  std::size_t queries;
  /// Answers the first so many of them; returns a sum of the answers, so that no answer is optimised away.
  std::function<std::uint64_t(std::size_t)> ask;
  /// How many of the first so many answers are wrong; not timed. Empty where there is no wrong answer.
  std::function<std::size_t(std::size_t)> count_wrong;
  /// Makes ready to be asked the first so many; not timed. May be empty.
  std::function<void(std::size_t)> before;
  std::optional<Comparison> comparison;
  /// Its wrong answers are counted among so many of those that the benchmark checks, where that is costly.
  std::size_t most_checked = std::numeric_limits<std::size_t>::max();
};

/// Candidates that answer the same queries.
struct Benchmark {
  std::string name;            ///< within its family; empty where there is but one
  std::string note;            ///< what the queries turned out to be
  std::string unit = "query";  ///< what is asked for so many times
  std::size_t checked = 0;     ///< so many answers of each are held against `exact`
  std::string pool;            ///< benchmarks of a family with the same pool are also reported together; empty: not
  std::vector<Candidate> candidates;
};

/// Answers of `ask` to a list of queries, compared with the truths of the first of them.
template <class Query, class Truth, class Ask>
Candidate candidate(std::string name, std::shared_ptr<const std::vector<Query>> queries,
                    std::shared_ptr<const std::vector<Truth>> truths, Ask ask,
                    std::optional<Comparison> comparison = std::nullopt) {
  const std::size_t size = queries->size();
  const auto sum_of_answers = [queries, ask](std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += static_cast<std::uint64_t>(ask((*queries)[i]));
    return sum;
  };
  const auto count_wrong = [queries, truths, ask](std::size_t count) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (ask((*queries)[i]) != (*truths)[i]) ++wrong;
    return wrong;
  };
  return {std::move(name), size, sum_of_answers, count_wrong, {}, std::move(comparison)};
}

}  // namespace touchstone::timing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace touchstone::timing {
namespace {

/// Receives the sums, so that they are computed.
volatile std::uint64_t sink;

/// Returns the time of the first `count` queries.
double seconds(const Candidate& candidate, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  if (candidate.before) candidate.before(count);
  const auto begin = Clock::now();
  sink = candidate.ask(count);
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Returns the number of queries that fit into a repetition; also warms up. Takes the best of three runs: other
/// processes may be using the machine.
std::size_t affordable(const Candidate& candidate, double most_seconds) {
  const double long_enough = most_seconds / 10;
  std::size_t count = 1;
  double spent = seconds(candidate, count);
  while (spent < long_enough && count < candidate.queries) {
    count = std::min(2 * count, candidate.queries);
    spent = seconds(candidate, count);
  }
  for (int again = 0; again < 2; ++again) spent = std::min(spent, seconds(candidate, count));
  const double all = spent * static_cast<double>(candidate.queries) / static_cast<double>(count);
  if (all <= most_seconds) return candidate.queries;
  return std::max<std::size_t>(1, static_cast<std::size_t>(most_seconds / spent * static_cast<double>(count)));
}

const Measured& find(const std::vector<Measured>& measured, const std::string& name) {
  const auto found = std::ranges::find(measured, name, &Measured::name);
  if (found == measured.end()) throw std::logic_error("a comparison with " + name + ", which is not a candidate");
  return *found;
}

void find_ratios(std::vector<Measured>& measured) {
  for (Measured& m : measured) {
    if (!m.comparison) continue;
    const Measured& base = find(measured, m.comparison->base);
    for (std::size_t i = 0; i < m.nanoseconds.size(); ++i) m.ratios.push_back(m.nanoseconds[i] / base.nanoseconds[i]);
  }
}

}  // namespace

bool too_noisy(const Quartiles& ratio) { return !(ratio.upper <= kMostSpread * ratio.lower); }

Quartiles quartiles(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
  };
  return {at(0), at(0.25), at(0.5), at(0.75), at(1)};
}

Result measure(const std::string& family, const Benchmark& benchmark, unsigned repetitions,
               const std::atomic<bool>& stop, const program::Progress& progress, double most_seconds) {
  const auto& candidates = benchmark.candidates;
  Result result{family, benchmark.name, benchmark.note, benchmark.unit, benchmark.pool, {}, benchmark.shares};
  for (const Candidate& c : candidates) {
    if (stop) break;
    result.candidates.push_back({c.name, affordable(c, most_seconds), {}, {}, c.comparison, {}});
  }
  for (unsigned repetition = 0; repetition < repetitions && !stop; ++repetition) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const std::size_t turn = (k + repetition) % candidates.size();
      Measured& m = result.candidates[turn];
      m.nanoseconds.push_back(1e9 * seconds(candidates[turn], m.queries) / static_cast<double>(m.queries));
    }
    progress(repetition + 1);
  }
  for (std::size_t k = 0; k < candidates.size() && benchmark.checked > 0 && !stop; ++k) {
    if (!candidates[k].count_wrong) continue;
    const std::size_t checked = std::min(benchmark.checked, candidates[k].most_checked);
    result.candidates[k].wrong = {candidates[k].count_wrong(checked), checked};
  }
  find_ratios(result.candidates);
  return result;
}

std::optional<Result> pooled(const std::vector<Result>& results, const std::string& pool) {
  std::optional<Result> sum;
  double members = 0;
  for (const Result& result : results) {
    if (result.pool != pool) continue;
    if (++members == 1) {
      sum = result;
      continue;
    }
    if (sum->candidates.size() != result.candidates.size()) return std::nullopt;
    for (std::size_t k = 0; k < result.candidates.size(); ++k) {
      Measured& total = sum->candidates[k];
      const Measured& part = result.candidates[k];
      if (total.nanoseconds.size() != part.nanoseconds.size()) return std::nullopt;
      total.queries += part.queries;
      if (total.wrong && part.wrong)
        total.wrong = {total.wrong->count + part.wrong->count, total.wrong->of + part.wrong->of};
      for (std::size_t i = 0; i < part.nanoseconds.size(); ++i) total.nanoseconds[i] += part.nanoseconds[i];
    }
  }
  if (members < 2) return std::nullopt;
  sum->name = pool;
  sum->note.clear();
  for (Measured& m : sum->candidates) {
    for (double& ns : m.nanoseconds) ns /= members;
    m.ratios.clear();
  }
  find_ratios(sum->candidates);
  return sum;
}

}  // namespace touchstone::timing

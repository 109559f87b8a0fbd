// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/measure.h"

#include <algorithm>
#include <array>

#include "experiments/methods/registry.h"

namespace touchstone::near_edge {
namespace {

using cases::PartialAnswer;

/// Asks the method about all of one crossing.
void ask(const cases::Method& method, bool knows_boundary, const cases::Crossing& crossing, std::size_t m,
         std::array<std::vector<TestFailures>, kTests.size()>& counts) {
  const auto prepared = method.prepare(crossing.polygon);
  std::vector<PartialAnswer> whole;  // of a program, whose every answer has all of its keys
  if (method.through_pipe())
    for (const Ball& ball : crossing.balls) whole.push_back(prepared->ask(ball, cases::QueryKind::Answer));
  for (const Test test : kTests) {
    std::vector<std::optional<Outcome>> outcomes;
    for (std::size_t i = 0; i < crossing.balls.size(); ++i) {
      const auto answer = whole.empty() ? prepared->ask(crossing.balls[i], query_kind(test)) : whole[i];
      const auto verdict = compare(test, answer, crossing.truths[i], knows_boundary);
      if (!verdict && !answer.unsure) break;  // the method has no such test
      outcomes.push_back(verdict);
    }
    if (outcomes.size() == crossing.balls.size()) counts[static_cast<std::size_t>(test)][m].add(outcomes);
  }
}

class Study {
 public:
  explicit Study(const Settings& settings) : settings_(settings) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  /// Sample n of every stratum of the selected families.
  void ask_all(std::uint64_t n, Result& part) const {
    const auto& families = settings_.families;
    for (std::size_t stratum = 0; stratum < cases::all_strata().size(); ++stratum)
      if (std::find(families.begin(), families.end(), cases::all_strata()[stratum].family) != families.end())
        ask_stratum({stratum, settings_.shape, settings_.seed, n}, part);
    ++part.samples;
  }

 private:
  void ask_stratum(const cases::SamplePlace& place, Result& part) const {
    const auto crossing = cases::draw_crossing(place, exact_);
    if (!crossing) {
      ++part.missing;
      return;
    }
    for (std::size_t m = 0; m < settings_.methods.size(); ++m)
      ask(*settings_.methods[m], knows_boundary_[m], *crossing, m, part.counts[place.stratum]);
  }

  const Settings& settings_;
  const cases::Method& exact_ = *methods::find_method("exact");
  std::vector<bool> knows_boundary_;
};

}  // namespace

void TestFailures::add(const std::vector<std::optional<Outcome>>& outcomes) {
  bool failed = false;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    offsets[i].add(outcomes[i]);
    failed |= outcomes[i] != Outcome::Right;
  }
  samples.add_sample(failed);
}

TestFailures sum(const Counts& counts, const std::vector<std::size_t>& strata, Test test, std::size_t method) {
  TestFailures sum;
  for (const std::size_t stratum : strata) run::add(sum, counts[stratum][static_cast<std::size_t>(test)][method]);
  return sum;
}

Result no_result(const Settings& settings) {
  Result result;
  result.counts.resize(cases::all_strata().size());
  for (auto& tests : result.counts) tests.fill(std::vector<TestFailures>(settings.methods.size()));
  return result;
}

void run_study(const Settings& settings, const run::RunControl& control, Result& result) {
  const Study study(settings);
  run::run_sweep(settings.samples, settings.threads, control, no_result(settings), result,
                 [&](std::uint64_t n, Result& part) { study.ask_all(n, part); });
}

}  // namespace touchstone::near_edge

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/measure.h"

#include "experiments/methods/registry.h"

namespace touchstone::near_edge {

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
  for (const std::size_t stratum : strata) program::add(sum, counts[stratum][static_cast<std::size_t>(test)][method]);
  return sum;
}

Result no_result(const Settings& settings) {
  Result result;
  result.counts.resize(cases::all_strata().size());
  for (auto& tests : result.counts) tests.fill(std::vector<TestFailures>(settings.methods.size()));
  return result;
}

void run_study(const Settings& settings, const program::RunControl& control, Result& result) {
  const cases::Method& exact = *methods::find_method("exact");
  cases::walk(
      {settings.methods, settings.samples, settings.threads}, control, no_result(settings), result,
      [&](std::uint64_t n, Result& part, const auto& visit) {
        ++part.samples;
        part.missing += cases::draw_crossings(settings, n, exact, visit);
      },
      [](Result& part, const cases::Crossing& crossing, std::size_t m, const cases::Asked& asked) {
        for (const Test test : kTests) {
          std::vector<std::optional<Outcome>> outcomes;
          asked.compare(test, [&](std::size_t, std::optional<Outcome> outcome) { outcomes.push_back(outcome); });
          if (outcomes.size() == crossing.balls.size())
            part.counts[crossing.stratum][static_cast<std::size_t>(test)][m].add(outcomes);
        }
      });
}

}  // namespace touchstone::near_edge

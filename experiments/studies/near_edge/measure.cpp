// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/measure.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <string>
#include <tuple>

#include "experiments/cases/output_lines.h"
#include "experiments/methods/registry.h"

namespace touchstone::near_edge {
namespace {

using cases::PartialAnswer;

/// All questions about one crossing.
class Sample {
 public:
  Sample(const Settings& settings, const cases::SamplePlace& place, const cases::Crossing& crossing, Result& result)
      : settings_(settings), place_(place), crossing_(crossing), result_(result) {
    for (auto& wrong : wrong_) wrong.resize(crossing.balls.size());
  }

  void ask(std::size_t m, bool knows_boundary) {
    const auto prepared = settings_.methods[m]->prepare(crossing_.polygon);
    std::vector<PartialAnswer> whole;  // of a program, whose every answer has all of its keys
    if (settings_.methods[m]->through_pipe())
      for (const Ball& ball : crossing_.balls) whole.push_back(prepared->ask(ball, cases::QueryKind::Answer));
    for (const Test test : kTests) {
      std::vector<std::optional<Outcome>> outcomes;
      for (std::size_t i = 0; i < crossing_.balls.size(); ++i) {
        const auto answer = whole.empty() ? prepared->ask(crossing_.balls[i], query_kind(test)) : whole[i];
        const auto verdict = compare(test, answer, crossing_.truths[i], knows_boundary);
        if (!verdict && !answer.unsure) break;  // the method has no such test
        outcomes.push_back(verdict);
        if (verdict && *verdict != Outcome::Right) wrong_[static_cast<std::size_t>(test)][i] = true;
      }
      if (outcomes.size() == crossing_.balls.size())
        result_.counts[place_.stratum][static_cast<std::size_t>(test)][m].add(outcomes);
    }
  }

  /// Compares the truth that was used with `exact`: about every ball, or those on which a method was wrong.
  void check(bool every_ball) {
    std::unique_ptr<cases::PreparedMethod> exact;
    std::vector<Disagreement> found;
    for (const Test test : kTests) {
      const std::vector<bool>& wrong = wrong_[static_cast<std::size_t>(test)];
      const auto failures = static_cast<std::size_t>(std::count(wrong.begin(), wrong.end(), true));
      const std::size_t count = every_ball ? crossing_.balls.size() : failures;
      if (count == 0) continue;
      if (!exact) exact = methods::find_method("exact")->prepare(crossing_.polygon);
      result_.checked += count;
      std::vector<PartialAnswer> growing;  // cheaper than one by one
      if (!every_ball && cases::moves_radius(cases::all_strata()[place_.stratum].threshold))
        growing = cases::ask_growing(crossing_.balls, query_kind(test), *exact);
      for (std::size_t i = 0; i < crossing_.balls.size(); ++i) {
        if (!every_ball && !wrong[i]) continue;
        const PartialAnswer truth = growing.empty() ? exact->ask(crossing_.balls[i], query_kind(test)) : growing[i];
        if (!same_value(key_of(test), truth, crossing_.truths[i])) found.push_back(disagreement(test, i, *exact));
      }
    }
    if (!found.empty()) result_.disagreements.add(std::move(found));
  }

 private:
  Disagreement disagreement(Test test, std::size_t i, const cases::PreparedMethod& exact) const {
    const Ball& ball = crossing_.balls[i];
    const std::vector<std::string> tags{std::string(to_string(test)), std::string(settings_.truth->name())};
    return {place_.n, place_.stratum,
            cases::case_line(id(place_) + "-k" + std::to_string(cases::all_offsets()[i]),
                             cases::Shapes{ball, crossing_.polygon}, tags, exact.ask(ball, cases::QueryKind::Answer))};
  }

  const Settings& settings_;
  const cases::SamplePlace& place_;
  const cases::Crossing& crossing_;
  Result& result_;
  std::array<std::vector<bool>, kTests.size()> wrong_;  ///< [test][ball]: was any method?
};

class Study {
 public:
  explicit Study(const Settings& settings)
      : settings_(settings), is_exact_(settings.truth == methods::find_method("exact")) {
    for (const auto* method : settings.methods) knows_boundary_.push_back(cases::knows_boundary(*method));
  }

  /// Sample n of every stratum of the selected families.
  void ask_all(std::uint64_t n, Result& part) const {
    const auto& families = settings_.families;
    for (std::size_t stratum = 0; stratum < cases::all_strata().size(); ++stratum)
      if (std::find(families.begin(), families.end(), cases::all_strata()[stratum].family) != families.end())
        ask({stratum, settings_.shape, settings_.seed, n}, part);
    ++part.samples;
  }

 private:
  void ask(const cases::SamplePlace& place, Result& part) const {
    const auto crossing = cases::draw_crossing(place, *settings_.truth);
    if (!crossing) {
      ++part.missing;
      return;
    }
    Sample sample(settings_, place, *crossing, part);
    for (std::size_t m = 0; m < settings_.methods.size(); ++m) sample.ask(m, knows_boundary_[m]);
    // The strata of one n are of different families and thresholds: so are those that are checked.
    if (!is_exact_) sample.check((place.n + place.stratum) % kCheckedOneIn == 0);
  }

  const Settings& settings_;
  bool is_exact_;
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

void Disagreements::add(std::vector<Disagreement> found) {
  count_ += found.size();
  std::move(found.begin(), found.end(), std::back_inserter(kept_));
  keep_first();
}

Disagreements& Disagreements::operator+=(const Disagreements& other) {
  count_ += other.count_;
  kept_.insert(kept_.end(), other.kept_.begin(), other.kept_.end());
  keep_first();
  return *this;
}

/// Those of one sample stay in their order.
void Disagreements::keep_first() {
  std::stable_sort(kept_.begin(), kept_.end(), [](const Disagreement& a, const Disagreement& b) {
    return std::tie(a.n, a.stratum) < std::tie(b.n, b.stratum);
  });
  if (kept_.size() > kMostKept) kept_.resize(kMostKept);
}

}  // namespace touchstone::near_edge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/methods/registry.h"
#include "experiments/run/run_control.h"
#include "experiments/studies/near_edge/counts.h"
#include "experiments/studies/near_edge/disagreements.h"

namespace touchstone::near_edge {

struct Settings {
  std::vector<const cases::Method*> methods;
  std::vector<workloads::Family> families;
  /// Per stratum; up to run::kMostSamples, indices of samples and of their redraws do not collide.
  std::uint64_t samples = 1;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  cases::Shape shape = {};
  /// The oracle that decides which answers are right. Unless it is `exact` itself, `exact` is also asked: about every
  /// ball of one sample in kCheckedOneIn, and about every ball for which a method seems wrong.
  const cases::Method* truth = methods::find_method("exact");
};

inline constexpr std::uint64_t kCheckedOneIn = 100;

/// The results of the study; sums do not depend on their order.
struct Result {
  Counts counts;
  std::uint64_t samples = 0;    ///< complete samples per stratum: fewer than requested if the run was stopped
  std::uint64_t missing = 0;    ///< samples, over all strata, for which no polygon or ball was found
  std::uint64_t checked = 0;    ///< balls, over all tests, for which another truth was compared with `exact`
  Disagreements disagreements;  ///< where they differed

  auto members() { return std::tie(counts, samples, missing, checked, disagreements); }
  friend bool operator==(const Result&, const Result&) = default;
};

[[nodiscard]] inline std::uint64_t items_done(const Result& result) { return result.samples; }

/// Returns an empty result.
[[nodiscard]] Result no_result(const Settings& settings);

/// Asks every method about every ball of every crossing that the result does not contain yet, and adds the answers to
/// it.
///
/// The result is a function of settings and the number of samples done. Threads, stops
/// and the other families and methods do not change the counts of one family and method. A run stopped after m samples
/// equals a run of m samples. Returns that number, in every process.
std::uint64_t run_study(const Settings& settings, const run::RunControl<Result>& course, Result& result);

}  // namespace touchstone::near_edge

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/methods/registry.h"
#include "experiments/studies/stability/known.h"
#include "experiments/studies/stability/measure.h"
#include "experiments/studies/stability/summary.h"
#include "tests/experiments/support/unwatched.h"

/// Runs of the study that are over in a moment.
namespace touchstone::stability {

inline Settings settings(const std::vector<std::string>& methods, std::vector<Axis> axes, std::uint64_t samples,
                         unsigned threads = 1) {
  return {methods::find_methods(methods), std::move(axes), samples, 5, threads};
}

inline Summary whole(const Settings& settings) {
  Summary summary = no_summary(settings);
  run_study(settings, {run_tests::kNeverStop, run_tests::kSilent}, summary);
  return summary;
}

inline Onset onset_of(const std::vector<std::string>& methods, std::uint64_t triangles, unsigned threads) {
  const auto found = methods::find_methods(methods);
  Onset onset = no_onset(found);
  find_onset(found, triangles, 3, threads, {run_tests::kNeverStop, run_tests::kSilent}, onset);
  return onset;
}

}  // namespace touchstone::stability

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/methods/registry.h"
#include "experiments/studies/tradeoff/errors.h"
#include "tests/experiments/support/unwatched.h"

namespace touchstone::tradeoff {

inline Settings settings(const std::vector<std::string>& names, std::uint64_t samples, unsigned threads = 1) {
  return {methods::find_methods(names), {workloads::Family::Star, workloads::Family::L}, samples, 7, threads};
}

/// Returns the results of a whole run.
inline Errors whole(const Settings& settings) {
  Errors errors = no_errors(settings);
  measure_errors(settings, {run_tests::kNeverStop, run_tests::kSilent}, errors);
  return errors;
}

}  // namespace touchstone::tradeoff

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "experiments/run/blocks.h"
#include "experiments/near_edge/counts.h"

namespace touchstone::near_edge {

struct Settings {
  std::vector<const methods::Method*> methods;
  std::vector<workloads::Family> families;
  std::uint64_t samples = 1;  ///< of each stratum
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

struct Result {
  Counts counts;
  std::uint64_t samples;  ///< of each stratum, all done: fewer than asked for where the run was stopped
  std::uint64_t missing;  ///< samples, of all, for which no polygon or ball was found
};

/// Asks every method about every ball of every crossing.
///
/// The result is a function of settings and the number of samples done; `threads` and the other families and methods
/// do not change the counts of one. A run stopped after m samples equals one of m samples.
[[nodiscard]] Result run_study(const Settings& settings, const std::atomic<bool>& stop, const run::Progress& progress);

}  // namespace touchstone::near_edge

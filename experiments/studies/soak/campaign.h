// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "experiments/harness/checkpoint.h"
#include "experiments/harness/sweep.h"
#include "experiments/studies/soak/contestant.h"
#include "experiments/studies/soak/tally.h"

namespace touchstone::soak {

struct Settings {
  std::uint64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  std::uint64_t from = 0;  ///< the index of the first case
  unsigned threads = 1;    ///< of each process
};

/// What a harness::Checkpoint of a tally asks for.
[[nodiscard]] harness::ResultSettings checkpoint_settings(const Settings& settings);

/// Asks about the cases from, from + 1, ... that the tally does not hold yet, and adds them to it in their order.
///
/// The first process's tally is a function of the contestant, seed, from and the number of cases that it holds;
/// processes, threads, pauses and stops do not change it. There, `save` is told it every few seconds, `progress` the
/// number of cases done. Returns the number of cases done, at all processes.
std::uint64_t run_campaign(const Settings& settings, const Contestant& contestant, const harness::Processes& processes,
                           const std::atomic<bool>& stop, const std::function<void(const Tally&)>& save,
                           const harness::Progress& progress, Tally& tally);

}  // namespace touchstone::soak

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "experiments/run/blocks.h"
#include "experiments/soak/contestant.h"
#include "experiments/soak/tally.h"

namespace touchstone::soak {

struct Settings {
  std::uint64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  std::uint64_t from = 0;  ///< the index of the first case
  unsigned threads = 1;
};

/// Asks about the cases from, from + 1, ... that the tally does not hold yet, and adds them to it in their order.
///
/// The tally is a function of the contestant, seed, from and the number of cases that it holds; threads, pauses and
/// stops do not change it. `save` is told it every few hundredths of a long run, `progress` the cases done in this one.
void run_campaign(const Settings& settings, const Contestant& contestant, const std::atomic<bool>& stop,
                  const std::function<void(const Tally&)>& save, const run::Progress& progress, Tally& tally);

}  // namespace touchstone::soak

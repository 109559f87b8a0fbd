// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/run/run_control.h"
#include "experiments/studies/soak/system_under_test.h"
#include "experiments/studies/soak/tally.h"

namespace touchstone::soak {

struct Settings {
  std::uint64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  std::uint64_t from = 0;  ///< the index of the first case
  unsigned threads = 1;
  bool moving = false;  ///< the balls move
};

/// Runs the cases from, from + 1, ... that the tally does not contain yet, and adds them to it in order.
///
/// The tally is a function of the system under test, seed, from and the number of cases that it contains; threads,
/// pauses and stops do not change it. Returns the number of cases done.
std::uint64_t run_campaign(const Settings& settings, const SystemUnderTest& tested,
                           const run::RunControl<Tally>& control, Tally& tally);

}  // namespace touchstone::soak

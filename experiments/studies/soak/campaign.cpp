// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/soak/campaign.h"

#include "experiments/studies/soak/comparison.h"

namespace touchstone::soak {

std::uint64_t run_campaign(const Settings& settings, const SystemUnderTest& tested,
                           const run::RunControl<Tally>& control, Tally& tally) {
  constexpr std::uint64_t kBlock = 256;  // about 10 ms on one core, 40 ms if balls move
  return run::run_sweep(
      settings.cases, settings.threads, control, Tally(), tally,
      [&](std::uint64_t i, Tally& part) {
        (settings.moving ? compare_moving : compare)(tested, settings.seed, settings.from + i, part);
      },
      kBlock);
}

}  // namespace touchstone::soak

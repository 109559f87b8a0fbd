// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/soak/campaign.h"

#include "experiments/studies/soak/comparison.h"

namespace touchstone::soak {

harness::ResultSettings checkpoint_settings(const Settings& settings) {
  constexpr int kVersion = 2;  // raised where case i of a seed becomes another one, or the tally's form changes
  return {kVersion, {{"seed", std::to_string(settings.seed)}, {"from", std::to_string(settings.from)}}};
}

std::uint64_t run_campaign(const Settings& settings, const SystemUnderTest& tested, const harness::Processes& processes,
                           const std::atomic<bool>& stop, const std::function<void(const Tally&)>& save,
                           const harness::Progress& progress, Tally& tally) {
  constexpr std::uint64_t kBlock = 256;  // about 10 ms on one core
  const harness::Sweep sweep{settings.cases, kBlock, settings.threads, processes, stop, progress};
  return harness::run_sweep(
      sweep, [&](std::uint64_t i, Tally& part) { compare(tested, settings.seed, settings.from + i, part); },
      [&](std::uint64_t, const Tally& now) { save(now); }, Tally(), tally.cases(), tally);
}

}  // namespace touchstone::soak

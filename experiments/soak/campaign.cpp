// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/soak/campaign.h"

#include <algorithm>
#include <vector>

#include "experiments/soak/comparison.h"

namespace touchstone::soak {
namespace {

constexpr std::uint64_t kBlock = 256;         // about 10 ms on one core
constexpr std::uint64_t kLeg = 128 * kBlock;  // between two chances to save: about one second

}  // namespace

void run_campaign(const Settings& settings, const Contestant& contestant, const std::atomic<bool>& stop,
                  const std::function<void(const Tally&)>& save, const run::Progress& progress, Tally& tally) {
  const std::uint64_t before = tally.cases();
  while (tally.cases() < settings.cases && !stop) {
    const std::uint64_t begin = tally.cases(), end = std::min(settings.cases, begin + kLeg);
    std::vector<Tally> parts(settings.threads);
    const auto ask_block = [&](unsigned thread, std::uint64_t block) {
      const std::uint64_t first = begin + block * kBlock, last = std::min(end, first + kBlock);
      for (std::uint64_t i = first; i < last; ++i) compare(contestant, settings.seed, settings.from + i, parts[thread]);
    };
    const std::uint64_t blocks = (end - begin + kBlock - 1) / kBlock;
    run::run_blocks(
        blocks, settings.threads, stop,
        [&](std::uint64_t done) { progress(std::min(end, begin + done * kBlock) - before); }, ask_block);
    for (const Tally& part : parts) tally += part;
    save(tally);
  }
}

}  // namespace touchstone::soak

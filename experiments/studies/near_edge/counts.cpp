// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/counts.h"

#include <algorithm>

namespace touchstone::near_edge {

Tally& Tally::operator+=(const Tally& other) {
  failures += other.failures;
  trials += other.trials;
  return *this;
}

Counts::Counts(std::size_t methods)
    : methods_(methods),
      tallies_(cases::all_strata().size() * kTests.size() * methods * (cases::all_offsets().size() + 1)) {}

std::size_t Counts::first(std::size_t stratum, Test test, std::size_t method) const {
  return ((stratum * kTests.size() + static_cast<std::size_t>(test)) * methods_ + method) *
         (cases::all_offsets().size() + 1);
}

void Counts::add(std::size_t stratum, Test test, std::size_t method, const std::vector<bool>& failed) {
  Tally* tally = &tallies_[first(stratum, test, method)];
  bool any = false;
  for (const bool failure : failed) {
    *tally++ += {failure ? 1U : 0U, 1};
    any = any || failure;
  }
  *tally += {any ? 1U : 0U, 1};
}

const Tally& Counts::at(std::size_t stratum, Test test, std::size_t method, std::size_t offset) const {
  return tallies_[first(stratum, test, method) + offset];
}

Summary Counts::summary(const std::vector<std::size_t>& strata, Test test, std::size_t method) const {
  const auto& offsets = cases::all_offsets();
  Summary summary;
  for (const std::size_t stratum : strata) {
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Tally& tally = at(stratum, test, method, i);
      summary.all += tally;
      if (tally.failures == 0) continue;
      summary.below = std::min(summary.below.value_or(offsets[i]), offsets[i]);
      summary.above = std::max(summary.above.value_or(offsets[i]), offsets[i]);
    }
    summary.samples += at(stratum, test, method, offsets.size());
  }
  return summary;
}

}  // namespace touchstone::near_edge

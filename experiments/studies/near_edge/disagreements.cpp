// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/near_edge/disagreements.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace touchstone::near_edge {

void Disagreements::add(std::vector<Disagreement> found) {
  count_ += found.size();
  std::move(found.begin(), found.end(), std::back_inserter(kept_));
  keep_first();
}

Disagreements& Disagreements::operator+=(const Disagreements& other) {
  count_ += other.count_;
  kept_.insert(kept_.end(), other.kept_.begin(), other.kept_.end());
  keep_first();
  return *this;
}

/// Those of one sample stay in their order.
void Disagreements::keep_first() {
  std::stable_sort(kept_.begin(), kept_.end(), [](const Disagreement& a, const Disagreement& b) {
    return std::tie(a.n, a.stratum) < std::tie(b.n, b.stratum);
  });
  if (kept_.size() > kMostKept) kept_.resize(kMostKept);
}

}  // namespace touchstone::near_edge

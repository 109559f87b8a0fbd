// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/soak/tally.h"

#include <algorithm>

namespace touchstone::soak {

std::string_view to_string(Way way) {
  switch (way) {
    case Way::Triangle: return "triangle";
    case Way::Prepared: return "prepared";
    case Way::Answer: return "answer";
    case Way::MovingTriangle: return "moving-triangle";
    case Way::MovingPrepared: break;
  }
  return "moving-prepared";
}

Outcomes& Outcomes::operator+=(const Outcomes& other) {
  cases += other.cases;
  for (std::size_t stage = 0; stage < by_stage.size(); ++stage) by_stage[stage] += other.by_stage[stage];
  differences += other.differences;
  return *this;
}

void Tally::add_case(std::vector<Difference> differences) {
  ++cases_;
  if (differences.empty()) return;
  ++differing_;
  std::move(differences.begin(), differences.end(), std::back_inserter(kept_));
  keep_first();
}

Tally& Tally::operator+=(const Tally& other) {
  for (std::size_t i = 0; i < outcomes_.size(); ++i) outcomes_[i] += other.outcomes_[i];
  cases_ += other.cases_;
  differing_ += other.differing_;
  kept_.insert(kept_.end(), other.kept_.begin(), other.kept_.end());
  keep_first();
  return *this;
}

/// By index; those of one case stay in their order.
void Tally::keep_first() {
  std::stable_sort(kept_.begin(), kept_.end(),
                   [](const Difference& a, const Difference& b) { return a.index < b.index; });
  if (kept_.size() > kMostKept) kept_.resize(kMostKept);
}

}  // namespace touchstone::soak

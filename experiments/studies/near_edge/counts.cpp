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

Counts& Counts::operator+=(const Counts& other) {
  for (std::size_t i = 0; i < tallies_.size(); ++i) tallies_[i] += other.tallies_[i];
  return *this;
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

void to_json(nlohmann::ordered_json& json, const Counts& counts) {
  std::vector<std::uint64_t> failures, trials;
  for (const Tally& tally : counts.tallies_) {
    failures.push_back(tally.failures);
    trials.push_back(tally.trials);
  }
  json = {{"methods", counts.methods_}, {"failures", failures}, {"trials", trials}};
}

void from_json(const nlohmann::json& json, Counts& counts) {
  counts = Counts(json.at("methods").get<std::size_t>());
  const auto &failures = json.at("failures"), &trials = json.at("trials");
  for (std::size_t i = 0; i < counts.tallies_.size(); ++i)
    counts.tallies_[i] = {failures.at(i).get<std::uint64_t>(), trials.at(i).get<std::uint64_t>()};
}

}  // namespace touchstone::near_edge

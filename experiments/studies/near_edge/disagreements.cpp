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

void to_json(nlohmann::ordered_json& json, const Disagreements& disagreements) {
  auto kept = nlohmann::ordered_json::array();
  for (const auto& [n, stratum, line] : disagreements.kept_) kept.push_back({n, stratum, line});
  json = {{"count", disagreements.count_}, {"kept", kept}};
}

void from_json(const nlohmann::json& json, Disagreements& disagreements) {
  disagreements = Disagreements();
  disagreements.count_ = json.at("count").get<std::uint64_t>();
  for (const auto& kept : json.at("kept"))
    disagreements.kept_.push_back(
        {kept.at(0).get<std::uint64_t>(), kept.at(1).get<std::uint64_t>(), kept.at(2).get<std::string>()});
}

}  // namespace touchstone::near_edge

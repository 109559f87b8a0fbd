// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/failures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace touchstone::cases {
namespace {

std::string offset_text(double offset) {
  if (offset == 0) return "0";
  const bool last = std::abs(offset) == all_offsets().back();
  return fmt::format("{}2^{}{}", offset < 0 ? "-" : "", std::ilogb(offset), last ? " or beyond" : "");
}

}  // namespace

void Failures::add(std::optional<Outcome> outcome) {
  ++trials;
  if (!outcome) {
    ++unsure;
    return;
  }
  wrong += *outcome != Outcome::Right ? 1 : 0;
  wrongly_in += *outcome == Outcome::WronglyIn ? 1 : 0;
  wrongly_out += *outcome == Outcome::WronglyOut ? 1 : 0;
}

void CrossingFailures::add(const Outcomes& outcomes, bool lifts) {
  Failures::add(lifts ? outcomes.contract : outcomes.as_given);
  if (outcomes.contract == Outcome::Right) return;
  ++contract;
  lift += outcomes.as_given == Outcome::Right ? 1 : 0;
}

void Failures::add_sample(bool failed) {
  ++trials;
  wrong += failed ? 1 : 0;
}

std::string to_string(const Band& band) {
  if (!band.lowest) return "none seen";
  if (band.lowest == band.highest) return offset_text(*band.lowest);
  return offset_text(*band.lowest) + " to " + offset_text(*band.highest);
}

std::vector<StratumGroup> stratum_groups(const CrossingSettings& settings) {
  std::vector<StratumGroup> single, pooled;
  for (std::size_t s = 0; s < all_strata().size(); ++s) {
    if (!settings.has(all_strata()[s])) continue;
    const auto& [family, placement, threshold] = all_strata()[s];
    single.push_back({std::string(to_string(family)), placement, threshold, {s}});
    auto group = std::ranges::find_if(pooled, [&, placement = placement, threshold = threshold](const auto& other) {
      return other.placement == placement && other.threshold == threshold;
    });
    if (group == pooled.end()) group = pooled.insert(group, {"all", placement, threshold, {}});
    group->strata.push_back(s);
  }
  single.insert(single.end(), pooled.begin(), pooled.end());
  return single;
}

}  // namespace touchstone::cases

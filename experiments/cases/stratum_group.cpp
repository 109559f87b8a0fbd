// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/stratum_group.h"

#include <algorithm>

namespace touchstone::cases {

std::vector<StratumGroup> stratum_groups(const std::vector<workloads::Family>& families) {
  std::vector<StratumGroup> single, pooled;
  for (std::size_t s = 0; s < all_strata().size(); ++s) {
    const auto& [family, placement, threshold] = all_strata()[s];
    if (std::ranges::find(families, family) == families.end()) continue;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/families.h"

namespace touchstone::bench {

const std::vector<Family>& all_families() {
  static const std::vector<Family> families = [] {
    std::vector<Family> list = triangle_families();
    for (Family& family : polygon_families()) list.push_back(std::move(family));
    list.push_back(batch_family());
    list.push_back(motion_family());
    list.push_back(nearness_family());
    list.push_back(variants_family());
    return list;
  }();
  return families;
}

}  // namespace touchstone::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/grazing_radius.h"

#include <limits>

#include "experiments/workloads/ulp.h"

namespace touchstone::workloads {

double grazing_radius(const Motion& motion, const std::function<bool(const Motion&)>& touches) {
  std::int64_t misses = ordinal(0) - 1, hits = ordinal(std::numeric_limits<double>::max());
  while (hits - misses > 1) {
    const std::int64_t middle = misses + (hits - misses) / 2;
    (touches(with_radius(motion, from_ordinal(middle))) ? hits : misses) = middle;
  }
  return from_ordinal(hits);
}

}  // namespace touchstone::workloads

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/grazing_radius.h"

#include <limits>

#include "experiments/cases/workloads/ulp.h"

namespace touchstone::workloads {

namespace {

const std::int64_t kLeast = ordinal(0) - 1, kMost = ordinal(std::numeric_limits<double>::max());

/// Returns the least ordinal that touches, given one that misses and one that touches.
template <class Touches>
double between(std::int64_t misses, std::int64_t hits, const Touches& touches) {
  while (hits - misses > 1) {
    const std::int64_t middle = misses + (hits - misses) / 2;
    (touches(middle) ? hits : misses) = middle;
  }
  return from_ordinal(hits);
}

/// Returns at most kMost.
std::int64_t twice(std::int64_t step) { return step > kMost / 2 ? kMost : 2 * step; }

}  // namespace

double grazing_radius(const Motion& motion, const std::function<bool(const Motion&)>& touches) {
  return between(kLeast, kMost,
                 [&](std::int64_t radius) { return touches(with_radius(motion, from_ordinal(radius))); });
}

double grazing_radius(const Motion& motion, const std::function<bool(const Motion&)>& touches, double estimate) {
  const auto touches_with = [&](std::int64_t radius) { return touches(with_radius(motion, from_ordinal(radius))); };
  std::int64_t misses = ordinal(estimate), hits = misses, step = 1;
  if (touches_with(misses)) {
    do {
      hits = misses, misses = hits - kLeast > step ? hits - step : kLeast, step = twice(step);
    } while (misses > kLeast && touches_with(misses));
  } else {
    do {
      misses = hits, hits = kMost - misses > step ? misses + step : kMost, step = twice(step);
    } while (hits < kMost && !touches_with(hits));
  }
  return between(misses, hits, touches_with);
}

}  // namespace touchstone::workloads

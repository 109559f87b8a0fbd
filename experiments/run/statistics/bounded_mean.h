// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/run/statistics/clopper_pearson.h"

namespace touchstone::statistics {

/// Returns two-sided confidence limits of the mean of a random variable in [0, 1], given the mean of `samples`
/// independent draws. Example: the share of wrong answers where each sample consists of several dependent queries.
///
/// The true mean lies within the limits in at least the share `confidence` of all experiments, for every distribution:
/// each limit m' solves exp(-samples KL(mean || m')) = (1 - confidence) / 2, where KL is the relative entropy.
///  (1) For means 0 and 1 the limits equal those of `clopper_pearson`; otherwise they are wider.
///  (2) lower <= mean <= upper.
/// Requires 0 <= mean <= 1 and 0 < confidence < 1. Source: [hoeffding1963, theorem 1].
[[nodiscard]] Limits bounded_mean(double mean, std::uint64_t samples, double confidence = 0.95);

}  // namespace touchstone::statistics

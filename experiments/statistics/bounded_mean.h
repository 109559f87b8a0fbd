// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "experiments/statistics/clopper_pearson.h"

namespace touchstone::statistics {

/// Two-sided confidence limits of the mean of a random variable in [0, 1], after `samples` independent draws of it with
/// this mean: such as the share of wrong answers where a sample is many questions that hang together.
///
/// The true mean lies between them in at least the share `confidence` of all experiments, whatever the distribution:
/// each limit m' is where exp(-samples KL(mean || m')) = (1 - confidence) / 2, KL the relative entropy.
///  (1) at means 0 and 1 equal to the limits of `clopper_pearson`, elsewhere wider;
///  (2) lower <= mean <= upper.
/// Requires 0 <= mean <= 1 and 0 < confidence < 1. Source: [hoeffding1963, theorem 1].
[[nodiscard]] Limits bounded_mean(double mean, std::uint64_t samples, double confidence = 0.95);

}  // namespace touchstone::statistics

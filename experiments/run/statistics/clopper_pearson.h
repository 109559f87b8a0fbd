// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::statistics {

/// Confidence limits of a probability.
struct Limits {
  double lower, upper;
};

/// Returns the exact two-sided confidence limits of a probability after `failures` in `trials` independent trials.
///
/// At each limit, the observed number of failures or a more extreme one has the probability (1 - confidence) / 2. The
/// true probability therefore lies within the limits in at least the share `confidence` of all experiments.
///  (1) Without failures, lower is 0; if every trial failed, upper is 1; without trials, the limits are 0 and 1.
///  (2) lower <= failures / trials <= upper.
/// Requires failures <= trials and 0 < confidence < 1.
/// Source: [clopper1934].
[[nodiscard]] Limits clopper_pearson(std::uint64_t failures, std::uint64_t trials, double confidence = 0.95);

}  // namespace touchstone::statistics

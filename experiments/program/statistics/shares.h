// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

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

/// Returns two-sided confidence limits of the mean of a random variable in [0, 1], given the mean of `samples`
/// independent draws. Example: the share of wrong answers where each sample consists of several dependent queries.
///
/// The true mean lies within the limits in at least the share `confidence` of all experiments, for every distribution:
/// each limit m' solves exp(-samples KL(mean || m')) = (1 - confidence) / 2, where KL is the relative entropy.
///  (1) For means 0 and 1 the limits equal those of `clopper_pearson`; otherwise they are wider.
///  (2) lower <= mean <= upper.
/// Requires 0 <= mean <= 1 and 0 < confidence < 1. Source: [hoeffding1963, theorem 1].
[[nodiscard]] Limits bounded_mean(double mean, std::uint64_t samples, double confidence = 0.95);

// Shares in percent, for people. Nothing looks like 0 or 100 % that is not: `<0.01`, `>99.9`.

/// Returns part / whole; 0 / 0 gives 0.
[[nodiscard]] double share_of(std::uint64_t part, std::uint64_t whole);

/// Formats a share as a percentage with `places` decimal places; exact shares of 0 and 1 have none.
[[nodiscard]] std::string percent_to_places(double share, int places);

/// Formats a share as a percentage with `digits` significant digits, and with at least one decimal place if it would
/// otherwise read as 100.
[[nodiscard]] std::string percent_to_digits(double share, int digits);

}  // namespace touchstone::statistics

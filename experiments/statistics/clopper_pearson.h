// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::statistics {

/// Limits between which a probability lies.
struct Limits {
  double lower, upper;
};

/// The exact two-sided confidence limits of a probability after `failures` in `trials` independent trials.
///
/// Each limit is the probability at which so many failures, or more extreme ones, have the chance (1 - confidence) / 2;
/// so the true probability lies between them in at least the share `confidence` of all experiments.
///  (1) no failure: lower is 0; nothing but failures: upper is 1; no trial: 0 and 1;
///  (2) lower <= failures / trials <= upper.
/// Requires failures <= trials and 0 < confidence < 1.
/// Source: [clopper1934].
[[nodiscard]] Limits clopper_pearson(std::uint64_t failures, std::uint64_t trials, double confidence = 0.95);

}  // namespace touchstone::statistics

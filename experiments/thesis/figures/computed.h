// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "experiments/program/statistics/shares.h"
#include "experiments/thesis/figures/study.h"

namespace touchstone::figures {

/// A number that the study computes.
struct Value {
  double value;
  std::optional<statistics::Limits> limits{};                     ///< 95 %, of a share of random samples
  std::uint64_t samples = 0, wrong = 0, right = 0;                ///< of a share; the counts of a ratio
  Value(double number) : value(number) {}                         // NOLINT: a number is a value
  Value(std::integral auto n) : Value(static_cast<double>(n)) {}  // NOLINT
};
/// Returns a share in percent of random samples, with its limits; 0 of no samples.
[[nodiscard]] Value share(std::uint64_t count, std::uint64_t samples);

/// The numbers and texts that figures.json names. Their names are the same for every study.
struct Computed {
  /// Nothing stands for what was not measured, in a study that was only begun, or did not happen.
  std::map<std::string, std::optional<Value>, std::less<>> numbers;
  std::map<std::string, std::string, std::less<>> texts;  ///< parts of sentences
};
[[nodiscard]] Computed computed(const Study& study);

/// Adds the known errors of the thesis's method.
void compute_errors(const Study& study, Computed& computed);

}  // namespace touchstone::figures

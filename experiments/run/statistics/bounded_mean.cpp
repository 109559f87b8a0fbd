// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.Math, which computes Clopper and Pearson's limits, has none for the mean of a bounded variable.
#include "experiments/run/statistics/bounded_mean.h"

#include <cmath>

namespace touchstone::statistics {
namespace {

/// Returns a log(a / b), continuous at a = 0.
double term(double a, double b) { return a == 0 ? 0 : a * std::log(a / b); }

double relative_entropy(double mean, double other) { return term(mean, other) + term(1 - mean, 1 - other); }

/// Solves for the limit between the mean, where the entropy is 0, and `end`, where it is infinite.
double limit(double mean, double end, double entropy) {
  double near = mean, far = end;
  constexpr int kEnough = 100;
  for (int step = 0; step < kEnough; ++step) {
    const double middle = near + (far - near) / 2;
    (relative_entropy(mean, middle) < entropy ? near : far) = middle;
  }
  return far;
}

}  // namespace

Limits bounded_mean(double mean, std::uint64_t samples, double confidence) {
  if (samples == 0) return {0, 1};
  const double entropy = std::log(2 / (1 - confidence)) / static_cast<double>(samples);
  return {mean == 0 ? 0 : limit(mean, 0, entropy), mean == 1 ? 1 : limit(mean, 1, entropy)};
}

}  // namespace touchstone::statistics

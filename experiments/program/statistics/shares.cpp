// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.Math inverts the incomplete beta function; Clopper and Pearson's limits follow from that and need no code of
// ours beyond the ends. It has no limits for the mean of a bounded variable.
#include "experiments/program/statistics/shares.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

namespace touchstone::statistics {
namespace {

// Boost.Math warms up with long doubles far below the range of double. Valgrind computes them as doubles, which
// overflow; the error would end the program before main. No limit overflows.
using Policy =
    boost::math::policies::policy<boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;

}  // namespace

Limits clopper_pearson(std::uint64_t failures, std::uint64_t trials, double confidence) {
  const auto failed = static_cast<double>(failures), passed = static_cast<double>(trials - failures);
  const double tail = (1 - confidence) / 2;
  return {failures == 0 ? 0 : boost::math::ibeta_inv(failed, passed + 1, tail, Policy{}),
          failures == trials ? 1 : boost::math::ibetac_inv(failed + 1, passed, tail, Policy{})};
}

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

double share_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string percent_to_places(double share, int places) {
  if (share == 0 || share == 1) return share == 0 ? "0" : "100";
  std::string text = fmt::format("{:.{}f}", 100 * share, places);
  if (share > 0 && std::stod(text) == 0) return fmt::format("<{:.{}f}", std::pow(10, -places), places);
  if (share < 1 && std::stod(text) >= 100) return fmt::format(">{:.{}f}", 100 - std::pow(10, -places), places);
  return text;
}

std::string percent_to_digits(double share, int digits) {
  const std::string text = fmt::format("{:.{}g}", 100 * share, digits);
  return std::stod(text) == 100 ? percent_to_places(share, std::max(1, digits - 2)) : text;
}

}  // namespace touchstone::statistics

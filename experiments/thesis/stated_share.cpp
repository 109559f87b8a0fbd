// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/stated_share.h"

#include <algorithm>
#include <cmath>

namespace touchstone::thesis_figures {
namespace {

double variance(double share, double right) {
  const double at_least = std::max(share, 1 / right);
  return at_least / right * (1 + at_least);
}

}  // namespace

double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples, const StatedShare& stated) {
  const auto right_here = static_cast<double>(right);
  const double right_then = right_here * static_cast<double>(stated.samples) / static_cast<double>(samples);
  const double share = static_cast<double>(wrong) / right_here;
  return 4 * std::sqrt(variance(share, right_here) + variance(stated.share, right_then)) + stated.unit / 2;
}

}  // namespace touchstone::thesis_figures

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/figures/stated_share.h"

#include <algorithm>
#include <cmath>

namespace touchstone::figures {

double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples, const StatedShare& stated) {
  const auto right_here = static_cast<double>(right);
  const double right_then = right_here * static_cast<double>(stated.samples) / static_cast<double>(samples);
  const double wrong_both = static_cast<double>(wrong) + stated.share * right_then;
  const double share = std::max(1.0, wrong_both) / (right_here + right_then);
  return 4 * std::sqrt(share * (1 + share) * (1 / right_here + 1 / right_then)) + stated.unit / 2;
}

}  // namespace touchstone::figures

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::figures {

/// A stated share w / r of w wrong and r right positive answers, from `samples` random samples, rounded to `unit`.
struct StatedShare {
  double share, unit;
  std::uint64_t samples;
};

/// Returns by how much our share, w' / r' of n' samples, may differ from a stated one, of n samples, if both estimate
/// the same p:
///
///     4 sqrt(v + v') + u / 2,   v = (p / r) (1 + p)   (delta method, w and r being two counts of one multinomial),
///
/// where u is the unit, r = r' n / n', and p is estimated from both sides together, so that a small sample of ours with
/// few wrong answers by chance does not narrow the result. Four standard deviations are a confidence of 99.994 % for
/// large counts. A count of 0 wrong answers on either side is taken as 1. Requires right > 0.
[[nodiscard]] double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples,
                               const StatedShare& stated);

}  // namespace touchstone::figures

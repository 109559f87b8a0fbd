// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace touchstone::thesis_figures {

/// A share w / r of w wrong yeses and r right ones, stated after so many random samples and rounded to `unit`.
struct StatedShare {
  double share, unit;
  std::uint64_t samples;
};

/// By how much our share, w' / r' of n' samples, may differ from a stated one, of n, where both estimate one p:
///
///     4 sqrt(v + v') + u / 2,   v = (p / r) (1 + p)   (delta method, w and r being two counts of one multinomial),
///
/// u being the unit, r = r' n / n' and p that of both sides together: few samples of ours, in which by chance hardly
/// any is wrong, do not narrow it. Four standard deviations are a confidence of 99.994 %, where counts are large. No
/// wrong one on either side weighs as one. Requires right > 0.
[[nodiscard]] double tolerance(std::uint64_t wrong, std::uint64_t right, std::uint64_t samples,
                               const StatedShare& stated);

}  // namespace touchstone::thesis_figures

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/statistics/clopper_pearson.h"
#include "experiments/studies/stability/outlines.h"

namespace touchstone::stability {

/// Points about an outline that the thesis's angle sum, with its factor of 0.99, calls inside or not.
struct FalseArea {
  const Outline* outline;
  std::uint64_t points = 0;
  std::uint64_t right = 0;   ///< called inside, and inside or on the boundary
  std::uint64_t wrong = 0;   ///< called inside, but outside
  std::uint64_t missed = 0;  ///< inside, but not called so

  /// The area wrongly called inside as a share of that rightly called so, which is the outline's own where nothing is
  /// missed. Requires a point rightly called inside.
  [[nodiscard]] double share() const;
  /// Of the share, 95 %: of the points called inside, the wrong ones are a binomial count.
  [[nodiscard]] statistics::Limits limits() const;
};

/// Uniform points in the bounding box, enlarged on each side by half its extent: what leaves that box is not counted.
///
/// A function of its arguments. The points of outlines of different names are independent, so that chance leads them
/// astray apart. Truth is `filtered`. Cost: about 1 us a point.
[[nodiscard]] FalseArea measure_false_area(const Outline& outline, std::uint64_t points, std::uint64_t seed);

}  // namespace touchstone::stability

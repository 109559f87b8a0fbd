// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/program/statistics/shares.h"
#include "experiments/thesis/figures/outlines.h"

namespace touchstone::figures {

/// Counts of points around an outline, by whether the thesis's angle sum, with its factor of 0.99, calls them inside.
struct FalseArea {
  const Outline* outline;
  std::uint64_t points = 0;
  std::uint64_t right = 0;   ///< called inside, and inside or on the boundary
  std::uint64_t wrong = 0;   ///< called inside, but outside
  std::uint64_t missed = 0;  ///< inside, but not called so

  /// Returns the area wrongly called inside, relative to the area rightly called inside, which is the outline's own
  /// area if nothing is missed. Requires a point rightly called inside.
  [[nodiscard]] double share() const;
  /// Returns the 95 % limits of the share: among the points called inside, the number of wrong ones is binomial.
  [[nodiscard]] statistics::Limits limits() const;
};

/// Draws uniform points in the bounding box, enlarged on each side by half its extent; false areas beyond that box are
/// not counted.
///
/// A function of its arguments. Outlines with different names have independent points, so that their random errors are
/// independent. The truth is `filtered`. Cost: about 1 us per point.
[[nodiscard]] FalseArea measure_false_area(const Outline& outline, std::uint64_t points, std::uint64_t seed);

/// The rivals of the thesis's test: the convex hull of an outline, and its decomposition into convex parts.
struct ConvexCover {
  double hull;        ///< the area in the hull outside the outline, relative to the outline's
  std::size_t parts;  ///< convex parts, which together are the outline
};
[[nodiscard]] ConvexCover convex_cover(const Outline& outline);

}  // namespace touchstone::figures

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "experiments/thesis/figures/outlines.h"

namespace touchstone::figures {

/// The rivals of the thesis's test: the convex hull of an outline, and its decomposition into convex parts.
struct ConvexCover {
  double hull;        ///< the area in the hull outside the outline, relative to the outline's
  std::size_t parts;  ///< convex parts, which together are the outline
};
[[nodiscard]] ConvexCover convex_cover(const Outline& outline);

}  // namespace touchstone::figures

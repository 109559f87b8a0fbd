// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "experiments/workloads/adversarial/scaling.h"
#include "experiments/workloads/random.h"

namespace touchstone::adversarial {

/// A polygon of any family of workloads, of up to 24 vertices and two holes, in an integer or a rotated frame, at up
/// to 2^20 sizes from the origin; in half of the draws with its vertices moved off the plane, by 2^-52 to 2^-3 sizes;
/// in a third scaled to extremes. The ball is drawn as for triangles, tangent on the lattice, or close to a
/// vertex at the origin.
///
/// Nothing where the loops came to meet. Cost: about 50 us.
[[nodiscard]] std::optional<BallAndPolygon> draw_outline(Random& random);

}  // namespace touchstone::adversarial

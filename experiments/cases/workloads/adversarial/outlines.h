// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::workloads::adversarial {

struct BallAndPolygon {
  Ball ball;
  Polygon polygon;
};

/// Scales everything by one power of two: near the least doubles, near the largest, where squares or products of four
/// lengths leave the range of doubles, or in between. Numbers that become subnormal may be rounded. Returns nothing if
/// a number leaves the range. Throws Rejected if neighbouring vertices become equal.
[[nodiscard]] std::optional<BallAndPolygon> scaled_to_extremes(Random& random, const Ball& ball,
                                                               const Polygon& polygon);

/// Draws a number of magnitude 2^-1074 to 2^-971 or 2^971 to 2^1023, with all or few of its bits, or zero.
[[nodiscard]] double extreme_number(Random& random);

/// Scales each coordinate by a power of two of its own, along one axis at least so that all of them are below 2^-970 or
/// above 2^970. Vertices and centre are scaled alike, or the centre gets numbers of its own. The radius is the exact
/// distance, such a number, or as it was. Returns nothing if that is not a ball and a polygon. Cost: about 0.1 ms.
[[nodiscard]] std::optional<BallAndPolygon> with_extreme_numbers(Random& random, const Ball& ball,
                                                                 const Polygon& polygon);

/// Draws a polygon of any family of workloads, with up to 24 vertices and two holes, in an integer or a rotated frame,
/// at up to 2^20 sizes from the origin. In half of the draws its vertices are moved off the plane, by 2^-52 to 2^-3
/// sizes; a third is scaled to extremes. The ball is drawn as for triangles, tangent on the lattice, or close to a
/// vertex at the origin.
///
/// Returns nothing if the moved loops meet. Cost: about 50 us.
[[nodiscard]] std::optional<BallAndPolygon> draw_outline(Random& random);

}  // namespace touchstone::workloads::adversarial

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::adversarial {

using workloads::loops_of;
using workloads::polygon_of;
using workloads::Random;

struct BallAndPolygon {
  Ball ball;
  Polygon polygon;
};

/// Scales everything by one power of two: near the least doubles, near the largest, where squares or products of four
/// lengths leave the range of doubles, or in between. Numbers that become subnormal may be rounded. Returns nothing if
/// a number leaves the range. Throws Rejected if neighbouring vertices become equal.
[[nodiscard]] std::optional<BallAndPolygon> scaled_to_extremes(Random& random, const Ball& ball,
                                                               const Polygon& polygon);

}  // namespace touchstone::adversarial

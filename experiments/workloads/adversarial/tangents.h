// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::adversarial {

using workloads::Random;

struct Tangent {
  Triangle triangle;
  Ball ball;
};

/// A ball at exactly its radius from the face's plane, an edge's line or a vertex, unless a sum in doubles was rounded;
/// most often that is the nearest feature.
///
/// Half of them in an integer frame, by Pythagorean triples and quadruples; half with edges along axes or in a
/// coordinate plane, every other coordinate with all its bits.
[[nodiscard]] Tangent tangent(Random& random);

}  // namespace touchstone::adversarial

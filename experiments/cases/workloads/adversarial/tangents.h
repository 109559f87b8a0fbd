// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::adversarial {

using workloads::Random;

struct Tangent {
  Triangle triangle;
  Ball ball;
};

/// Draws a ball whose radius equals exactly the distance from the plane of the face, the line of an edge, or a vertex,
/// unless a sum in doubles was rounded. Most often that is the nearest feature.
///
/// Half of them lie in an integer frame, by Pythagorean triples and quadruples. The others have edges along axes or in
/// a coordinate plane, and every other coordinate has all its bits.
[[nodiscard]] Tangent tangent(Random& random);

}  // namespace touchstone::adversarial

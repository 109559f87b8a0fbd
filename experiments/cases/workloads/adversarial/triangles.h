// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::workloads::adversarial {

// Each function draws triangles that are hard in one way. Vertices may be equal or collinear; see `is_triangle`.

/// Draws coordinates in [-1, 1) with all their bits.
[[nodiscard]] Triangle general_triangle(Random& random);
/// Draws integers of up to 26 bits; axes and vertices often share coordinates.
[[nodiscard]] Triangle lattice_triangle(Random& random);
/// Draws a third vertex within some doubles of the line through the others, or of one of them.
[[nodiscard]] Triangle needle_triangle(Random& random);
/// Draws a triangle at up to 2^50 sizes from the origin.
[[nodiscard]] Triangle far_triangle(Random& random);
/// Draws coordinates each of its own magnitude, or zero, or equal to that of another vertex.
[[nodiscard]] Triangle triangle_of_all_exponents(Random& random);

/// Returns whether the vertices are not collinear. Exact.
[[nodiscard]] bool is_triangle(const Triangle& triangle);

/// Returns the largest coordinate difference of two vertices.
[[nodiscard]] double size_of(const Triangle& triangle);

/// Draws a double from one of the ranges of exponents of triangle_of_all_exponents.
[[nodiscard]] double number_of_any_exponent(Random& random, int range);
inline constexpr int kExponentRanges = 6;

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

}  // namespace touchstone::workloads::adversarial

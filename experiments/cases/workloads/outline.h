// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/cases/workloads/lattice.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"

namespace touchstone::workloads {

// Loops of one family each, with random proportions. The number of vertices is as close to `vertices`, at most 2^17, as
// the family allows. Comb, spiral, U, L and E are simple by construction. The others are nearly always simple;
// `draw_outline` draws again if not.

/// Draws a triangle of three random points.
[[nodiscard]] LatticeLoop triangle(Random& random);
/// Draws a convex loop of at least 3 vertices; straight runs may occur. Source: [valtr1995].
[[nodiscard]] LatticeLoop convex(Random& random, std::size_t vertices);
/// Draws a star-shaped loop: sorted directions, random radii. At least 5 vertices.
[[nodiscard]] LatticeLoop star(Random& random, std::size_t vertices);
/// Draws rectangular teeth (4 vertices each) or saw teeth (2 each) on a bar.
[[nodiscard]] LatticeLoop comb(Random& random, std::size_t vertices);
/// Draws a corridor that winds inwards about a square or a triangle. An even number of vertices, at least 8.
[[nodiscard]] LatticeLoop spiral(Random& random, std::size_t vertices);
/// Draws a simple polygon through random points, by 2-opt moves; if these cycle, it takes other points. At least 4
/// vertices; takes 1 s for 1,000 vertices. Source: [cgal2022], random_polygon_2.
[[nodiscard]] LatticeLoop random_simple(Random& random, std::size_t vertices);
/// Draws a square or an equilateral triangle whose edges are repeatedly replaced by four edges of 4^(-1/dimension)
/// times their length, pointing outwards. The number of vertices is 3 or 4 times a power of 4, at least 12. Requires 1
/// < dimension < 2; 1.2618... gives von Koch's snowflake.
[[nodiscard]] LatticeLoop koch(Random& random, std::size_t vertices, double dimension);
/// Draws letters of 8, 6 and 12 vertices.
[[nodiscard]] LatticeLoop letter_u(Random& random);
[[nodiscard]] LatticeLoop letter_l(Random& random);
[[nodiscard]] LatticeLoop letter_e(Random& random);

/// Draws the outline of sample `index`: family, vertices, holes and koch_dimension of the workload, one of the eight
/// symmetries of the square, a random first vertex and orientation. `exact::validate` accepts it, and it is non-convex
/// if the family promises that. Throws std::invalid_argument if no such outline was found.
[[nodiscard]] Outline draw_outline(const Workload& workload, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::workloads

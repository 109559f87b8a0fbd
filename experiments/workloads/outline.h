// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/workloads/lattice.h"
#include "experiments/workloads/random.h"
#include "experiments/workloads/workload.h"

namespace touchstone::workloads {

// Loops of one family each, random in their proportions. `vertices` is met as nearly as the family allows and is at
// most 2^17. Comb, spiral, U, L and E are simple by construction; the others nearly always: `draw_outline` draws again.

/// Three random points.
[[nodiscard]] LatticeLoop triangle(Random& random);
/// At least 3 vertices; straight runs may occur. Source: [valtr1995].
[[nodiscard]] LatticeLoop convex(Random& random, std::size_t vertices);
/// Star-shaped: sorted directions, random radii. At least 5 vertices.
[[nodiscard]] LatticeLoop star(Random& random, std::size_t vertices);
/// Rectangular teeth (4 vertices each) or saw teeth (2 each) on a bar.
[[nodiscard]] LatticeLoop comb(Random& random, std::size_t vertices);
/// A corridor that winds inwards about a square or a triangle. An even number of vertices, at least 8.
[[nodiscard]] LatticeLoop spiral(Random& random, std::size_t vertices);
/// A simple polygon through random points, by 2-opt moves; where these go in circles, through others. At least 4
/// vertices; 1 s for 1,000 of them.
/// Source: [cgal2022], random_polygon_2.
[[nodiscard]] LatticeLoop random_simple(Random& random, std::size_t vertices);
/// A square or an equilateral triangle whose edges are replaced, again and again, by four edges of
/// 4^(-1/dimension) times their length, pointing outwards. 3 or 4 times a power of 4 vertices, at least 12.
/// Requires 1 < dimension < 2; 1.2618... is von Koch's snowflake.
[[nodiscard]] LatticeLoop koch(Random& random, std::size_t vertices, double dimension);
/// Letters of 8, 6 and 12 vertices.
[[nodiscard]] LatticeLoop letter_u(Random& random);
[[nodiscard]] LatticeLoop letter_l(Random& random);
[[nodiscard]] LatticeLoop letter_e(Random& random);

/// The outline of sample `index`: family, vertices, holes and koch_dimension of the workload, one of the eight
/// symmetries of the square, a random first vertex and orientation. Accepted by `exact::validate`, and non-convex
/// where the family promises it. Throws std::invalid_argument where no such outline was found.
[[nodiscard]] Outline draw_outline(const Workload& workload, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::workloads

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/cases/workloads/random.h"

namespace touchstone::stability {

struct FlatPoint {
  double x, y;
};

/// An outline in its own plane, before it is placed: about 2 across, except for those on an integer lattice.
struct Flat {
  std::vector<FlatPoint> points;
  std::vector<std::size_t> critical;  ///< the vertices under stress; empty if all are alike
  double size = 2;                    ///< the longer side of its box
  double feature = 2;                 ///< the size of the stressed part

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i > 0 ? i : points.size()) - 1; }
};

using workloads::Random;

/// Draws a triangle.
[[nodiscard]] Flat flat_triangle(Random& random);
/// Draws a triangle, star, comb, L, U or E of at most 12 vertices, in the square of side 2 around zero.
[[nodiscard]] Flat flat_outline(Random& random);
/// Draws one of the same shapes, unscaled on the integer lattice, at most 2^21 across.
[[nodiscard]] Flat flat_lattice_outline(Random& random);
/// Draws a square with a crack of this angle (at critical[0]); its mouth is at zero. Requires angle <= 1.
[[nodiscard]] Flat flat_crack(Random& random, double angle);
/// Draws an outline with a side that turns by this angle at critical[0], at zero, and a dent elsewhere. Requires turn
/// <= 1.
[[nodiscard]] Flat flat_bend(Random& random, double turn);
/// Draws an outline with a corner at zero cut off: the neighbours critical[0] and [1] are the given share of the size
/// apart; a dent elsewhere.
[[nodiscard]] Flat flat_cut_corner(Random& random, double distance);
/// Draws an outline with a pocket around zero, whose mouth, from critical[0] to [1], is the given share of the size
/// wide.
[[nodiscard]] Flat flat_pocket(Random& random, double mouth);
/// Draws a dented rectangle with `count` additional vertices on its first side, on the integer lattice, 2^20 across.
[[nodiscard]] Flat flat_straight_run(Random& random, std::size_t count);
/// Draws an outline that is star-shaped around zero, with random radii, on the integer lattice, 2^41 across. Requires 5
/// <= count <= 2^30.
[[nodiscard]] Flat flat_star(Random& random, std::size_t count);

/// Returns whether a point is inside, by the even-odd rule in doubles: possibly wrong near the boundary.
[[nodiscard]] bool contains(const Flat& flat, FlatPoint point);
/// Returns the distance to the nearest edge, in doubles.
[[nodiscard]] double clearance(const Flat& flat, FlatPoint point);
/// Returns twice the signed area, in doubles; positive for a counterclockwise outline.
[[nodiscard]] double twice_area(const Flat& flat);

}  // namespace touchstone::stability

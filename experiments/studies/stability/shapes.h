// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/workloads/random.h"

namespace touchstone::stability {

struct FlatPoint {
  double x, y;
};

/// An outline in its own plane, before it is placed: about 2 across, but for those on an integer lattice.
struct Flat {
  std::vector<FlatPoint> points;
  std::vector<std::size_t> critical;  ///< the vertices at which the stress is; none: everywhere alike
  double size = 2;                    ///< the longer side of its box
  double feature = 2;                 ///< the size of what is stressed

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i > 0 ? i : points.size()) - 1; }
};

using workloads::Random;

/// A triangle.
[[nodiscard]] Flat flat_triangle(Random& random);
/// A triangle, star, comb, L, U or E of at most 12 vertices, in the square of side 2 about zero.
[[nodiscard]] Flat flat_outline(Random& random);
/// The same as they are on the integer lattice, at most 2^21 across.
[[nodiscard]] Flat flat_lattice_outline(Random& random);
/// A square into which a crack with this angle (at critical[0]) runs; its mouth is at zero. Requires angle <= 1.
[[nodiscard]] Flat flat_crack(Random& random, double angle);
/// A side that turns by this angle at critical[0], at zero; a dent elsewhere. Requires turn <= 1.
[[nodiscard]] Flat flat_bend(Random& random, double turn);
/// A corner at zero is cut off: critical[0] and [1], neighbours, are so many sizes apart; a dent elsewhere.
[[nodiscard]] Flat flat_cut_corner(Random& random, double distance);
/// A pocket whose mouth, critical[0] and [1], is so many sizes wide, about zero.
[[nodiscard]] Flat flat_pocket(Random& random, double mouth);
/// On the integer lattice, 2^20 across: a dented rectangle with `count` more vertices on its first side.
[[nodiscard]] Flat flat_straight_run(Random& random, std::size_t count);
/// On the integer lattice, 2^41 across: star-shaped about zero, with random radii. Requires 5 <= count <= 2^30.
[[nodiscard]] Flat flat_star(Random& random, std::size_t count);

/// Even-odd, in doubles: near the boundary it may err.
[[nodiscard]] bool contains(const Flat& flat, FlatPoint point);
/// Distance to the nearest edge, in doubles.
[[nodiscard]] double clearance(const Flat& flat, FlatPoint point);
/// Twice the signed area, in doubles; positive for a counterclockwise outline.
[[nodiscard]] double twice_area(const Flat& flat);

}  // namespace touchstone::stability

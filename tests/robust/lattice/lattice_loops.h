// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/contact/answer.h"

namespace touchstone::lattice_tests {

/// A point with integer coordinates in the plane.
struct LatticePoint {
  int x, y;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// The vertices of a closed loop in order.
using LatticeLoop = std::vector<LatticePoint>;

/// Every loop with vertices on the lattice {0, ..., width - 1} x {0, ..., height - 1}, at most `most_vertices` of them,
/// that may touch itself, but neither crosses nor overlaps itself: once, not once for each start and direction.
/// Straight runs of edges are legal.
[[nodiscard]] std::vector<LatticeLoop> valid_loops(int width, int height, std::size_t most_vertices);

/// Where a point lies in the region that loops bound, by the even-odd rule. In integers, and by another ray than the
/// library's: it goes up and a little to the right.
[[nodiscard]] PointLocation place(const std::vector<LatticeLoop>& loops, const LatticePoint& point);

/// Twice the area that the loop runs around counter-clockwise.
[[nodiscard]] int doubled_area(const LatticeLoop& loop);

}  // namespace touchstone::lattice_tests

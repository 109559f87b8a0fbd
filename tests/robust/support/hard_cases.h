// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/robust/support/generators.h"

namespace touchstone::contact_tests {

/// The cases of `touchstone soak`, of all its families: what shrinks is the index, its id names seed and index.
[[nodiscard]] rc::Gen<Case> soak_cases();

/// Balls at the threshold radius, -9 to 9 doubles from it, or 2^k doubles; of samples and grid cases.
[[nodiscard]] rc::Gen<Case> threshold_cases();

/// Balls whose centre is a vertex, or on an edge's midpoint, or whose radius is zero, least, or largest.
[[nodiscard]] rc::Gen<Case> degenerate_balls();

/// Loops off their planes by 1 to 2^40 doubles in every coordinate, or up to a tenth of their size.
[[nodiscard]] rc::Gen<Case> off_plane_cases();

/// Samples times 2^k near both ends of the doubles and where products of two or four lengths leave them.
[[nodiscard]] rc::Gen<Case> scaled_cases();

/// An island in a hole in a polygon, on the lattice or rotated, the ball over any rim.
[[nodiscard]] rc::Gen<Case> islands();

/// All of these, and `any_case`.
[[nodiscard]] rc::Gen<Case> hard_cases();

/// Those that are triangles.
[[nodiscard]] rc::Gen<Case> hard_triangles();

}  // namespace touchstone::contact_tests

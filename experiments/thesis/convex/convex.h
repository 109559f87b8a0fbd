// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::convex {

// What the thesis sets out to avoid: the convex hull of a polygon, and convex parts of it.

/// Returns the convex hull of a polygon's outer loop, without its holes: a loop of its own vertices, seen along the
/// dropped axis, with the orientation of the outer loop and without vertices on straight runs. Requires a polygon that
/// exact::validate accepts. Source: CGAL's ch_graham_andrew (GPL).
[[nodiscard]] Polygon convex_hull(const Polygon& polygon);

/// Returns convex polygons of a polygon's vertices that cover it once: triangles, joined across their common edges as
/// long as the result stays convex. At most four times as many as are needed, if it has no hole. Requires as above.
/// Cost: O(n^2 log n). Source: Hertel and Mehlhorn (1983).
[[nodiscard]] std::vector<Polygon> convex_parts(const Polygon& polygon);

/// Adds the methods `hull` and `convex-parts`, which ask `fast` about them, as methods::add_methods does.
void add_methods();

}  // namespace touchstone::convex

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/shapes/polygon.h"

namespace touchstone::methods {

/// Triangles of a polygon's own vertices, by number, that cover it once and turn as its outer loop does. Vertices on
/// straight runs are corners too. Those of a constrained Delaunay triangulation of the polygon with the dropped axis
/// left out. Requires a polygon that exact::validate accepts; of an outline of n vertices with h holes come n - 2 + 2
/// h, if no hole lies in another. A triangle may be degenerate in space only where the polygon is not planar. Source:
/// CGAL's Constrained_Delaunay_triangulation_2 (GPL).
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon);

}  // namespace touchstone::methods

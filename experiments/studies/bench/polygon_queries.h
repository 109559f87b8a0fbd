// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::bench {

/// How far vertices are off the plane in which their outline was drawn, each to a random side along the axis that is
/// dropped.
struct OffPlane {
  std::string name;  ///< such as `2^20 ulps`: units in the last place of the polygon's size
  double share;      ///< of the size; 0 is exactly planar
};

[[nodiscard]] const std::vector<OffPlane>& all_off_plane();

/// Outlines that can have so many vertices: star, comb, spiral, and up to 1,024 vertices random-simple, beyond koch.
[[nodiscard]] std::vector<workloads::Family> outlines_of(std::size_t vertices);

/// Polygon number `index` of these, exactly planar: on an integer lattice in an integer frame. A function of its
/// arguments alone, as is what follows; `exact::validate` accepts it. Throws std::invalid_argument where none was
/// found.
[[nodiscard]] Polygon draw_polygon(workloads::Family outline, std::size_t vertices, std::uint64_t seed,
                                   std::uint64_t index);
/// The same polygon with its vertices off the plane; accepted too. Requires one without holes.
[[nodiscard]] Polygon move_off_plane(const Polygon& polygon, const OffPlane& off_plane, std::uint64_t seed,
                                     std::uint64_t index);

struct PolygonQuery {
  Ball ball;
  std::uint32_t polygon;
};

/// Small balls about each of the polygons in turn. Ball number `index`: its foot uniform in the bounding box of the
/// vertices (as seen along the dropped axis), its radius (0.05 to 0.15) x size / sqrt(n), its height at most the
/// radius; so it always meets the plane.
[[nodiscard]] std::vector<PolygonQuery> draw_balls(const std::vector<Polygon>& polygons, std::uint64_t seed,
                                                   std::uint64_t count);

}  // namespace touchstone::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::bench {

/// The distance of vertices from the plane in which their outline was drawn, each to a random side along the dropped
/// axis.
struct OffPlane {
  std::string name;  ///< such as `2^20 ulps`: units in the last place of the polygon's size
  double share;      ///< of the size; 0 is exactly planar
};

[[nodiscard]] const std::vector<OffPlane>& all_off_plane();

/// Returns the outlines that can have `vertices` vertices: star, comb, spiral, and random-simple up to
/// kMostRandomSimple vertices, koch beyond.
[[nodiscard]] std::vector<workloads::Family> outlines_of(std::size_t vertices);

/// Draws polygon number `index` of these, exactly planar: on an integer lattice in an integer frame. A function of its
/// arguments alone, as are the functions below; `exact::validate` accepts it. Throws std::invalid_argument if none was
/// found.
[[nodiscard]] Polygon draw_polygon(workloads::Family outline, std::size_t vertices, std::uint64_t seed,
                                   std::uint64_t index);
/// Draws several where they are small, so that no single one decides.
[[nodiscard]] std::vector<Polygon> draw_polygons(workloads::Family outline, std::size_t vertices, std::uint64_t seed);
[[nodiscard]] std::vector<Polygon> draw_polygons_of_all_outlines(std::size_t vertices, std::uint64_t seed);
/// Returns the same polygon with its vertices off the plane; also accepted by `exact::validate`. Requires a polygon
/// without holes.
[[nodiscard]] Polygon move_off_plane(const Polygon& polygon, const OffPlane& off_plane, std::uint64_t seed,
                                     std::uint64_t index);

struct PolygonQuery {
  Ball ball;
  std::uint32_t polygon;
};

/// Draws small balls near each of the polygons in turn. The foot of ball number `index` is uniform in the bounding box
/// of the vertices (as seen along the dropped axis), its radius is (0.05 to 0.15) x size / sqrt(n), and its height is
/// at most the radius, so that it always meets the plane.
[[nodiscard]] std::vector<PolygonQuery> draw_balls(const std::vector<Polygon>& polygons, std::uint64_t seed,
                                                   std::uint64_t count);

struct PolygonMotion {
  Motion motion;
  std::uint32_t polygon;
};

/// Draws motions that pass through the places of these balls in any direction, on ways of up to the polygon's size.
[[nodiscard]] std::vector<PolygonMotion> draw_motions(const std::vector<Polygon>& polygons, std::uint64_t seed,
                                                      std::uint64_t count);

}  // namespace touchstone::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

/// Triangulates a polygon: returns triangles of its own vertices, by number, that cover it once and have the
/// orientation of its outer loop. Vertices on straight runs are corners, too. The triangles are those of a constrained
/// Delaunay triangulation of the polygon without the dropped axis. Requires a polygon that exact::validate accepts. An
/// outline of n vertices with h holes yields n - 2 + 2 h triangles if no hole lies in another. A triangle may be
/// degenerate in space only if the polygon is not planar. Source: CGAL's Constrained_Delaunay_triangulation_2 (GPL).
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(const Polygon& polygon);

/// Returns the triangles of the polygon: the polygon itself if it is a triangle, else those of `triangulate`.
[[nodiscard]] std::vector<Triangle> triangles_of(const Polygon& polygon);

/// Triangles, and the same as numbers of vertices, in the two forms that libraries take. Vertices of equal coordinates
/// are one vertex, in the order of their first use.
struct Mesh {
  /// The triangles must outlive the mesh.
  explicit Mesh(std::span<const Triangle> all);

  std::span<const Triangle> triangles;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::int32_t, 3>> corners;  ///< the vertices of each triangle, by number
};

}  // namespace touchstone::methods

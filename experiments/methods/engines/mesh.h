// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

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

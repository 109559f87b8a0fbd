// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/scene/box_tree.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/filtered.h"

namespace touchstone::scene {

/// Triangles, leaf by leaf as their tree has them.
struct TriangleSet {
  explicit TriangleSet(const std::vector<Triangle>& by_number);

  [[nodiscard]] std::size_t memory() const;
  [[nodiscard]] std::size_t edge_count() const { return 3 * triangles.size(); }

  BoxTree tree;
  std::vector<Triangle> triangles;  ///< by place in tree.order()
};

/// Polygons by number. A polygon's box is that of its lifted vertices, rounded outwards.
struct PolygonSet {
  explicit PolygonSet(std::vector<Polygon> by_number);

  [[nodiscard]] std::size_t edge_count() const { return edges; }

  std::vector<Polygon> polygons;
  std::vector<filtered::PreparedPolygon> prepared;
  BoxTree tree;
  std::size_t edges;  ///< of all polygons
};

}  // namespace touchstone::scene

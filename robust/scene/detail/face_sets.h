// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/bvh/box_tree.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"
#include "robust/scene/detail/lazy_prepared_polygons.h"

namespace touchstone::scene {

/// Triangles under a pose, leaf by leaf as their tree has them.
struct TriangleSet {
  /// Throws FaceRejected for the lowest triangle that is none.
  explicit TriangleSet(const std::vector<Triangle>& by_number);
  /// The same triangles under another pose: vertices are posed anew from the model's, the tree is refitted. Throws
  /// FaceRejected for the lowest triangle that becomes none.
  TriangleSet(const TriangleSet& other, const Pose& pose);

  [[nodiscard]] std::size_t memory() const;
  [[nodiscard]] std::size_t edge_count() const { return 3 * triangles.size(); }

  BoxTree tree;
  std::vector<Triangle> triangles;                     ///< by place in tree.order()
  std::shared_ptr<const std::vector<Triangle>> model;  ///< what is posed, likewise; none where that changes nothing
};

/// Polygons under a pose, by number. A polygon's box holds its lifted vertices.
struct PolygonSet {
  /// Throws Rejected for a polygon without a normal.
  explicit PolygonSet(std::vector<Polygon> by_number);
  /// As for triangles.
  PolygonSet(const PolygonSet& other, const Pose& pose);

  [[nodiscard]] std::size_t edge_count() const { return edges; }

  std::vector<Polygon> polygons;
  std::shared_ptr<const std::vector<Polygon>> model;  ///< what is posed; none where that changes nothing
  LazyPreparedPolygons prepared;
  BoxTree tree;
  std::size_t edges;  ///< of all polygons
};

/// Thrown for a face that is none under a pose.
struct FaceRejected {
  std::size_t number;  ///< in its set
  Rejection rejection;
};

}  // namespace touchstone::scene

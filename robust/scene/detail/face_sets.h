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

/// Triangles under a pose, stored in the order of their tree's leaves.
struct TriangleSet {
  /// Throws FaceRejected for the lowest invalid triangle.
  explicit TriangleSet(const std::vector<Triangle>& by_number);
  /// Makes the set of the same triangles under another pose: poses the vertices of the model and refits the tree.
  /// Throws FaceRejected for the lowest triangle that becomes invalid.
  TriangleSet(const TriangleSet& other, const Pose& pose);

  [[nodiscard]] std::size_t memory() const;
  [[nodiscard]] std::size_t edge_count() const { return 3 * triangles.size(); }

  BoxTree tree;
  std::vector<Triangle> triangles;  ///< by place in tree.order()
  std::shared_ptr<const std::vector<Triangle>>
      model;  ///< the triangles before posing, in the same order; null if the pose is the identity
};

/// Polygons under a pose, by number. The box of a polygon contains its lifted vertices.
struct PolygonSet {
  /// Throws Rejected for a polygon without a normal.
  explicit PolygonSet(std::vector<Polygon> by_number);
  /// Makes the set of the same polygons under another pose, as for triangles.
  PolygonSet(const PolygonSet& other, const Pose& pose);

  [[nodiscard]] std::size_t edge_count() const { return edges; }

  std::vector<Polygon> polygons;
  std::shared_ptr<const std::vector<Polygon>> model;  ///< the polygons before posing; null if the pose is the identity
  LazyPreparedPolygons prepared;
  BoxTree tree;
  std::size_t edges;  ///< of all polygons
};

/// Thrown for a face that is invalid under a pose.
struct FaceRejected {
  std::size_t number;  ///< in its set
  Rejection rejection;
};

}  // namespace touchstone::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/bvh/box.h"
#include "geometry/bvh/box_tree.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/detail/sets/triangle_groups.h"
#include "robust/filtered/filtered.h"
#include "robust/scene/detail/own_frame.h"
#include "robust/scene/detail/shared_vertices.h"

namespace touchstone::scene::detail {

/// Polygons by number, each of which is prepared when it is first accessed. Several threads may access them at once.
class LazyPreparedPolygons {
 public:
  /// Keeps a reference. Requires polygons that have a normal.
  explicit LazyPreparedPolygons(const std::vector<Polygon>& polygons)
      : polygons_(polygons), prepared_(new std::atomic<const filtered::PreparedPolygon*>[polygons.size()]()) {}
  ~LazyPreparedPolygons();
  LazyPreparedPolygons(const LazyPreparedPolygons&) = delete;
  LazyPreparedPolygons& operator=(const LazyPreparedPolygons&) = delete;

  // Always inlined: a compiled function that was built for AVX2 could be linked into code for other machines.
  __attribute__((always_inline)) const filtered::PreparedPolygon& operator[](std::size_t number) const {
    const filtered::PreparedPolygon* known = prepared_[number].load(std::memory_order_acquire);
    return known != nullptr ? *known : prepare(number);
  }

 private:
  const filtered::PreparedPolygon& prepare(std::size_t number) const;

  const std::vector<Polygon>& polygons_;
  std::unique_ptr<std::atomic<const filtered::PreparedPolygon*>[]> prepared_;
};

/// Triangles in the order of their tree's leaves, and each leaf as a group that floats decide together.
struct PlacedTriangles {
  /// Requires valid triangles, and their boxes.
  PlacedTriangles(BoxTree tree, const std::vector<Box>& boxes, const std::vector<Triangle>& by_number);

  BoxTree tree;
  Box box;                                              ///< of all triangles
  TrianglesOfSharedVertices triangles;                  ///< by place in tree.order()
  std::vector<filtered::detail::TriangleGroup> groups;  ///< by leaf of the tree
};

/// Triangles under a pose. They stay in their own frame, so that a new pose costs the same for any number of them, or
/// are posed all, if OwnFrame cannot hold them.
///
/// Degenerate triangles need no lists of their own. What floats and doubles decide first is the distance of points of
/// the triangle, and the certain signs of edges and corners, which are as true of a segment. The certain signs of a
/// face are not zero, and those of a degenerate triangle are: no first stage finds it inside, missed by its plane or
/// pierced.
struct TriangleSet {
  /// Throws FaceRejected for the lowest invalid triangle.
  explicit TriangleSet(const std::vector<Triangle>& by_number, Degenerate degenerate = Degenerate::Refuse);
  /// Makes the set of the same triangles under another pose. Throws FaceRejected for the lowest triangle that becomes
  /// invalid.
  TriangleSet(const TriangleSet& other, const Pose& pose);

  [[nodiscard]] std::size_t memory() const;
  /// Returns a box that contains all triangles under the pose. Requires round to nearest, without flush-to-zero.
  [[nodiscard]] Box box() const;
  [[nodiscard]] std::size_t size() const { return model->tree.size(); }
  /// Returns a length such that no vertex of `placed` is farther from the origin; infinite if all triangles were posed.
  [[nodiscard]] double reach_of_placed() const {
    return placed == model ? reach : std::numeric_limits<double>::infinity();
  }
  /// Returns the triangle at a place of the tree, under the pose. Requires round to nearest, without flush-to-zero.
  [[nodiscard]] Triangle triangle(std::uint32_t place) const;

  std::shared_ptr<const PlacedTriangles> model;   ///< the triangles as they were added
  std::shared_ptr<const PlacedTriangles> placed;  ///< the model, or all triangles posed
  std::optional<OwnFrame> frame;                  ///< the pose, if `placed` is the model and it is not the identity
  double reach = 0;                               ///< no vertex of the model is farther from the origin
  double thinnest = 0;                            ///< no altitude of the model is less, if that matters
  Degenerate degenerate = Degenerate::Refuse;     ///< what to do with degenerate triangles, also under a pose
};

/// Polygons under a pose, by number. The box of a polygon contains its lifted vertices.
struct PolygonSet {
  /// Throws Rejected for a polygon without a normal.
  explicit PolygonSet(std::vector<Polygon> by_number);
  /// Makes the set of the same polygons under another pose: poses all and refits the tree. Throws FaceRejected for the
  /// lowest polygon that becomes invalid.
  PolygonSet(const PolygonSet& other, const Pose& pose);

  std::vector<Polygon> polygons;
  std::shared_ptr<const std::vector<Polygon>> model;  ///< the polygons before posing; null if the pose is the identity
  LazyPreparedPolygons prepared;
  BoxTree tree;
  Box box;  ///< of all polygons, lifted
};

/// Thrown for a face that is invalid under a pose.
struct FaceRejected {
  std::size_t number;  ///< in its set
  Rejection rejection;
};

}  // namespace touchstone::scene::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "robust/filtered/detail/triangle/triangle_crossing.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/first_contact_search.h"
#include "robust/scene/detail/nearest_search.h"
#include "robust/scene/scene.h"

namespace touchstone::scene::detail {

/// A face that a ball of a crowd touches.
struct TouchedFace {
  std::uint32_t ball;
  FaceId face;
};
/// A triangle, by its place in the tree of an object, that may be the nearest to a ball of a crowd.
struct PlaceOfBall {
  std::uint32_t ball, object, place;
};

/// The walks of many balls together through the triangles of an object. Balls have their numbers in the crowd.
struct CrowdWalks {
  /// Sets touches[i] to 1 for each ball i that touches a triangle. Leaves out balls for which it is 1.
  void (*touches_triangle)(std::span<const Ball>, const TriangleSet&, std::span<std::uint8_t> touches);
  /// Adds the triangles that the balls touch, in no particular order. `first` is the first face of the set.
  void (*touched_triangles)(std::span<const Ball>, const TriangleSet&, FaceId first, std::vector<TouchedFace>&);
  /// Adds the triangles of this object that may be nearest to the balls' centres; radii[i] shrinks to a radius with
  /// which ball i touches one that was found so far, or becomes NaN for a ball that has to search alone. Leaves out
  /// balls for which it is NaN.
  void (*nearest_triangles)(std::span<const Ball>, const TriangleSet&, std::uint32_t object, std::span<double> radii,
                            std::vector<PlaceOfBall>&);
};

/// The walks through an object for contact with a ball or a motion.
template <class Query>
struct ContactWalks {
  /// Returns whether the ball touches a face of the set.
  bool (*touches_triangle)(const Query&, const TriangleSet&);
  bool (*touches_polygon)(const Query&, const PolygonSet&);
  /// Adds the faces that the ball touches, in no particular order. `first` is the first face of the set.
  void (*touched_triangles)(const Query&, const TriangleSet&, FaceId first, std::vector<FaceId>&);
  void (*touched_polygons)(const Query&, const PolygonSet&, FaceId first, std::vector<FaceId>&);
};

/// The walks through an object.
///
/// Requires round to nearest, without flush-to-zero.
struct Walks {
  ContactWalks<Ball> ball;
  ContactWalks<Motion> motion;
  /// Passes to the search every face that is not farther than the nearest one found so far.
  void (*nearest_triangle)(const TriangleSet&, NearestSearch&);
  void (*nearest_polygon)(const PolygonSet&, NearestSearch&);
  /// Passes to the search every face that the motion does not touch later than the first one found so far.
  void (*first_triangle)(const TriangleSet&, FirstContactSearch&);
  void (*first_polygon)(const PolygonSet&, FirstContactSearch&);
  /// Returns how often the ray leaves through the triangles, less how often it enters; nothing if its point is on one.
  /// Requires triangles without a pose.
  std::optional<int> (*crossings)(const TriangleSet&, const filtered::detail::AxisRay&);
  CrowdWalks crowd;
};

// Compiled once for each instruction set; all give the same answers.
[[nodiscard]] const Walks& baseline_walks();
[[nodiscard]] const Walks& avx2_walks();

/// Returns the fastest walks that this machine can run.
[[nodiscard]] const Walks& fastest_walks();

}  // namespace touchstone::scene::detail

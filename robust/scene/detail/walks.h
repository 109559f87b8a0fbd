// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "robust/filtered/detail/triangle/triangle_crossing.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/first_contact_search.h"
#include "robust/scene/detail/nearest_search.h"
#include "robust/scene/scene.h"

namespace touchstone::scene::detail {

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
};

// Compiled once for each instruction set; all give the same answers.
[[nodiscard]] const Walks& baseline_walks();
[[nodiscard]] const Walks& avx2_walks();

/// Returns the fastest walks that this machine can run.
[[nodiscard]] const Walks& fastest_walks();

}  // namespace touchstone::scene::detail

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/ball.h"
#include "robust/scene/face_sets.h"
#include "robust/scene/nearest_face.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

/// The walks, compiled once for each instruction set. All give the same answers.
///
/// Requires round to nearest, without flush-to-zero.
struct Engine {
  bool (*touches_triangle)(const Ball&, const TriangleSet&);
  bool (*touches_polygon)(const Ball&, const PolygonSet&);
  /// Adds the faces that the ball touches, in no order; the set's first face is given.
  void (*touched_triangles)(const Ball&, const TriangleSet&, FaceId first, std::vector<FaceId>&);
  void (*touched_polygons)(const Ball&, const PolygonSet&, FaceId first, std::vector<FaceId>&);
  /// Shows every face to the search that is not farther than what it has found.
  void (*nearest_triangle)(const TriangleSet&, NearestSearch&);
  void (*nearest_polygon)(const PolygonSet&, NearestSearch&);
};

[[nodiscard]] const Engine& baseline_engine();
[[nodiscard]] const Engine& avx2_engine();

/// The fastest engine that this machine can run.
[[nodiscard]] const Engine& engine();

}  // namespace touchstone::scene

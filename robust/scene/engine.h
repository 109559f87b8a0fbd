// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/ball.h"
#include "robust/scene/face_sets.h"
#include "robust/scene/nearest_face.h"
#include "robust/scene/scene.h"
#include "robust/scene/tally.h"

namespace touchstone::scene {

/// The walks through an object, for one way of counting (NoTally, Tally).
///
/// Requires round to nearest, without flush-to-zero.
template <class T>
struct Walks {
  /// With a Tally the answer is `answered`, not what is returned: the walk goes on and counts what is left.
  bool (*touches_triangle)(const Ball&, const TriangleSet&, T&);
  bool (*touches_polygon)(const Ball&, const PolygonSet&, T&);
  /// Adds the faces that the ball touches, in no order; the set's first face is given.
  void (*touched_triangles)(const Ball&, const TriangleSet&, FaceId first, std::vector<FaceId>&, T&);
  void (*touched_polygons)(const Ball&, const PolygonSet&, FaceId first, std::vector<FaceId>&, T&);
  /// Shows every face to the search that is not farther than what it has found.
  void (*nearest_triangle)(const TriangleSet&, NearestSearch&, T&);
  void (*nearest_polygon)(const PolygonSet&, NearestSearch&, T&);
};

/// The walks, compiled once for each instruction set. All give the same answers.
struct Engine {
  Walks<NoTally> plain;
  Walks<Tally> counted;

  [[nodiscard]] const Walks<NoTally>& walks(NoTally) const { return plain; }
  [[nodiscard]] const Walks<Tally>& walks(const Tally&) const { return counted; }
};

[[nodiscard]] const Engine& baseline_engine();
[[nodiscard]] const Engine& avx2_engine();

/// The fastest engine that this machine can run.
[[nodiscard]] const Engine& engine();

}  // namespace touchstone::scene

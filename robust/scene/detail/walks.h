// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/first_contact_search.h"
#include "robust/scene/detail/nearest_search.h"
#include "robust/scene/detail/tally.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

/// The walks through an object for contact with a ball or a motion.
template <class Query, class T>
struct ContactWalks {
  /// Returns whether the ball touches a face of the set. With a Tally the walk continues and counts all faces; then the
  /// answer is `answered()`, not the returned value.
  bool (*touches_triangle)(const Query&, const TriangleSet&, T&);
  bool (*touches_polygon)(const Query&, const PolygonSet&, T&);
  /// Adds the faces that the ball touches, in no particular order. `first` is the first face of the set.
  void (*touched_triangles)(const Query&, const TriangleSet&, FaceId first, std::vector<FaceId>&, T&);
  void (*touched_polygons)(const Query&, const PolygonSet&, FaceId first, std::vector<FaceId>&, T&);
};

/// The walks through an object, for one way of counting (NoTally, Tally).
///
/// Requires round to nearest, without flush-to-zero.
template <class T>
struct Walks {
  ContactWalks<Ball, T> ball;
  ContactWalks<Motion, T> motion;
  /// Passes to the search every face that is not farther than the nearest one found so far.
  void (*nearest_triangle)(const TriangleSet&, NearestSearch&, T&);
  void (*nearest_polygon)(const PolygonSet&, NearestSearch&, T&);
  /// Passes to the search every face that the motion does not touch later than the first one found so far.
  void (*first_triangle)(const TriangleSet&, FirstContactSearch&, T&);
  void (*first_polygon)(const PolygonSet&, FirstContactSearch&, T&);
};

// Compiled once for each instruction set; all give the same answers.
[[nodiscard]] const Walks<NoTally>& baseline_walks();
[[nodiscard]] const Walks<NoTally>& avx2_walks();
// In separate translation units, so that counting does not affect the code of the walks that do not count.
[[nodiscard]] const Walks<Tally>& baseline_counted_walks();
[[nodiscard]] const Walks<Tally>& avx2_counted_walks();

/// Returns the fastest walks that this machine can run.
[[nodiscard]] const Walks<NoTally>& fastest_walks(NoTally);
[[nodiscard]] const Walks<Tally>& fastest_walks(const Tally&);

}  // namespace touchstone::scene

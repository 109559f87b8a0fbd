// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"

/// The study of wrong answers on the faces of third-party meshes: `touchstone meshes`.
namespace touchstone::meshes {

/// The object to which a ball is near.
enum class BallRegion {
  Face,    ///< the radius is near the distance to the polygon, whose nearest feature is the face
  Edge,    ///< the same, a drawn edge
  Vertex,  ///< the same, a drawn vertex
  Foot,    ///< the foot is near a drawn edge, the radius ample
};
inline constexpr std::array kPlaces{BallRegion::Face, BallRegion::Edge, BallRegion::Vertex, BallRegion::Foot};

[[nodiscard]] std::string_view to_string(BallRegion place);

/// The distances by which balls are moved, in doubles.
inline constexpr std::array kSteps{-2, -1, 0, 1, 2};

/// A ball near a place. For Foot, `steps` moves the centre along one axis; otherwise it moves the radius, from the
/// double nearest to the exact distance.
struct MeshBall {
  BallRegion place;
  int steps;
  Ball ball;
};

struct MeshBalls {
  std::vector<MeshBall> balls;  ///< one per step for each place that is not missing, in order
  std::vector<BallRegion>
      missing;  ///< places for which no ball was found, such as needles thinner than the spacing of doubles near them
};

/// Draws balls near one face of a mesh; a function of the arguments alone. Distances are log-uniform, from a hundredth
/// of the face's size to four times it, and smaller only if such balls miss the feature. Every nearest feature is
/// verified by `exact`, which must be prepared from the same polygon.
[[nodiscard]] MeshBalls draw_mesh_balls(const Polygon& polygon, const exact::PreparedPolygon& exact, std::uint64_t seed,
                                        std::string_view mesh, std::uint64_t face);

}  // namespace touchstone::meshes

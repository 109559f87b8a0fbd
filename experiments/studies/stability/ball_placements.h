// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "experiments/cases/workloads/placement.h"
#include "experiments/studies/stability/shapes.h"

namespace touchstone::stability {

/// The nearness of a ball to the decision boundary of a test.
///  - OneDouble: the radius is the double nearest to the exact distance, or one double off; or the foot is drawn on an
///    edge and lies within some doubles of it.
///  - Close: the radius is 2^-30 of the distance off; the foot 2^-31 of the outline's size.
///  - Ample: the radius is a quarter of the distance off; the foot a 32nd of the size.
enum class Nearness { OneDouble, Close, Ample };
inline constexpr std::array kNearnesses{Nearness::OneDouble, Nearness::Close, Nearness::Ample};

[[nodiscard]] std::string_view to_string(Nearness nearness);

/// The place of a ball's centre: above the face, off an edge or off a vertex, for radii around the distance; or with
/// its foot at an edge, for tests of the foot alone.
struct BallPlacement {
  enum class Site { Face, Edge, Vertex, Foot } site;
  Eigen::Vector3d center;
  Nearness nearness = Nearness::Ample;  ///< for Foot
  double radius = 0;                    ///< for Foot: ample
};

/// Draws one placement of each site (for Foot: two or more of each nearness), half of them at the critical vertices, if
/// any. Ignores the effect of the stress on sizes: a placement that is ample in the plane of the outline may be near
/// its boundary in space, as part of the stress.
[[nodiscard]] std::vector<BallPlacement> draw_placements(Random& random, const Flat& flat,
                                                         const workloads::Frame& frame);

}  // namespace touchstone::stability

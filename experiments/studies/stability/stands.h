// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "experiments/studies/stability/shapes.h"
#include "experiments/workloads/placement.h"

namespace touchstone::stability {

/// How near a ball stands to the boundary that a test asks about.
///  - OneDouble: the radius is the double nearest to the exact distance, or one double off; or the foot is drawn on an
///    edge, and lies within some doubles of it.
///  - Close: the radius is 2^-30 of the distance off; the foot 2^-31 of the outline's size.
///  - Ample: the radius is a quarter of the distance off; the foot a 32nd of the size.
enum class Nearness { OneDouble, Close, Ample };
inline constexpr std::array kNearnesses{Nearness::OneDouble, Nearness::Close, Nearness::Ample};

[[nodiscard]] std::string_view word(Nearness nearness);

/// Where the centre of a ball stands: above the face, off an edge or off a vertex, to have the radius moved about the
/// distance; or with its foot at an edge, for the foot alone.
struct Stand {
  enum class Site { Face, Edge, Vertex, Foot } site;
  Eigen::Vector3d center;
  Nearness nearness = Nearness::Ample;  ///< of Foot
  double radius = 0;                    ///< of Foot: ample
};

/// One stand of each site (for Foot: two or more of each nearness), half of them at the critical vertices, if there are
/// any. What the stress does to sizes is not looked at: a stand that was ample in the plane of the outline may come to
/// lie near its boundary in space. That is the stress.
[[nodiscard]] std::vector<Stand> draw_stands(Random& random, const Flat& flat, const workloads::Frame& frame);

}  // namespace touchstone::stability

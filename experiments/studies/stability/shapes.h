// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"

namespace touchstone::stability {

struct FlatPoint {
  double x, y;
};

/// An outline in its own plane, before it is placed: about 2 across, except for those on an integer lattice.
struct Flat {
  std::vector<FlatPoint> points;
  std::vector<std::size_t> critical;  ///< the vertices under stress; empty if all are alike
  double size = 2;                    ///< the longer side of its box
  double feature = 2;                 ///< the size of the stressed part

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 < points.size() ? i + 1 : 0; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i > 0 ? i : points.size()) - 1; }
};

using workloads::Random;

/// Draws a triangle.
[[nodiscard]] Flat flat_triangle(Random& random);
/// Draws a triangle, star, comb, L, U or E of at most 12 vertices, in the square of side 2 around zero.
[[nodiscard]] Flat flat_outline(Random& random);
/// Draws one of the same shapes, unscaled on the integer lattice, at most 2^21 across.
[[nodiscard]] Flat flat_lattice_outline(Random& random);
/// Draws a square with a crack of this angle (at critical[0]); its mouth is at zero. Requires angle <= 1.
[[nodiscard]] Flat flat_crack(Random& random, double angle);
/// Draws an outline with a side that turns by this angle at critical[0], at zero, and a dent elsewhere. Requires turn
/// <= 1.
[[nodiscard]] Flat flat_bend(Random& random, double turn);
/// Draws an outline with a corner at zero cut off: the neighbours critical[0] and [1] are the given share of the size
/// apart; a dent elsewhere.
[[nodiscard]] Flat flat_cut_corner(Random& random, double distance);
/// Draws an outline with a pocket around zero, whose mouth, from critical[0] to [1], is the given share of the size
/// wide.
[[nodiscard]] Flat flat_pocket(Random& random, double mouth);
/// Draws a dented rectangle with `count` additional vertices on its first side, on the integer lattice, 2^20 across.
[[nodiscard]] Flat flat_straight_run(Random& random, std::size_t count);
/// Draws an outline that is star-shaped around zero, with random radii, on the integer lattice, 2^41 across. Requires 5
/// <= count <= 2^30.
[[nodiscard]] Flat flat_star(Random& random, std::size_t count);

/// Returns whether a point is inside, by the even-odd rule in doubles: possibly wrong near the boundary.
[[nodiscard]] bool contains(const Flat& flat, FlatPoint point);
/// Returns the distance to the nearest edge, in doubles.
[[nodiscard]] double clearance(const Flat& flat, FlatPoint point);
/// Returns twice the signed area, in doubles; positive for a counterclockwise outline.
[[nodiscard]] double twice_area(const Flat& flat);

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

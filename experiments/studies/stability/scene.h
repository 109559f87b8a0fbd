// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/studies/stability/stress.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::stability {

using workloads::Random;

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

/// Draws the matrix of a rotation by about one degree about a random axis. Each entry is the double nearest to that of
/// an exact rational rotation, so, like almost every matrix of doubles, the result is not exactly a rotation.
[[nodiscard]] Eigen::Matrix3d small_rotation(Random& random);

/// Returns the points after `steps` successive multiplications by the matrix in doubles. Cost: about 5 ns per step and
/// point.
[[nodiscard]] std::vector<Eigen::Vector3d> rotated_in_steps(std::vector<Eigen::Vector3d> points,
                                                            const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// Returns the power of the matrix by `steps` successive multiplications in doubles.
[[nodiscard]] Eigen::Matrix3d pose_in_steps(const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// Returns the point under a pose: matrix times point exactly, then each coordinate rounded once to the nearest double.
[[nodiscard]] Eigen::Vector3d posed(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& point);

/// A polygon, and the places of the centres of its balls.
struct Placed {
  Polygon polygon;
  std::vector<BallPlacement> placements;
};

/// A rounding direction, and whether subnormal results (FTZ) and operands (DAZ) are replaced by zero: bits of the
/// MXCSR. Without SSE2 nothing is flushed.
struct FloatingPointMode {
  static constexpr unsigned kGivenAsZero = 0x8000, kTakenAsZero = 0x0040;

  int rounding = FE_TONEAREST;
  unsigned flush = 0;

  [[nodiscard]] bool usual() const { return rounding == FE_TONEAREST && flush == 0; }
};

/// A polygon under stress.
struct Scene {
  std::string id;                     ///< names axis, level, seed and sample: everything needed to draw it again
  Placed asked;                       ///< the input of methods
  std::optional<Placed> meant;        ///< for ChainMotion and PoseMotion: before the motion, placement by placement
  FloatingPointMode mode;             ///< the mode in which methods prepare and answer
  std::vector<std::size_t> critical;  ///< the vertices under stress
};

/// Draws sample `index` of a level of an axis, a function of (axis, level, seed, index) alone; Rounding and Flush have
/// the same scenes at each level. The polygon is accepted by `exact::validate`, and its stress as measured (stress.h)
/// is within a factor of 2 of the level if the level is a ratio, an angle or a distance, and exactly the level if it is
/// a count. Returns nothing if no such polygon was found.
///
/// Polygons that an oblique plane or rounding would break or blur are axis-parallel, or around zero, where doubles are
/// dense; others have any orientation and place. Requires rounding to nearest. Cost: that of exact::validate, plus 5 ns
/// per rotation and vertex.
[[nodiscard]] std::optional<Scene> draw_scene(Axis axis, std::size_t level, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::stability

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::workloads {

/// Families of outlines of simple polygons; all but Triangle and Convex are non-convex.
enum class Family { Triangle, Convex, Star, Comb, Spiral, RandomSimple, Koch, U, L, E };

/// The placement of an outline of the integer lattice in space.
enum class Placement {
  LatticeFrame,  ///< by an integer frame of few bits: every vertex exact, the loop exactly planar
  Planar,        ///< the same by a frame of as many bits as fit, so that products of coordinates are rounded
  Rotated,       ///< by a rational rotation, rounded to doubles: off its plane by rounding errors
};

/// The position of the ball.
enum class BallPlace {
  Anywhere,        ///< centre in the outline's enlarged bounding box, at any height; radius log-uniform
  NearFace,        ///< radius the double nearest to the exact distance, moved by `doubles`; closest feature the face
  NearEdge,        ///< the same, closest feature an edge
  NearVertex,      ///< the same, closest feature a vertex
  FootNearEdge,    ///< the foot within a few doubles of an edge; ample radius
  FootNearVertex,  ///< the foot within a few doubles of a vertex; ample radius
  LatticeTangent,  ///< exactly tangent: distance and radius are the same integer (LatticeFrame only)
};

/// The way of the ball, whose place is that of BallPlace.
enum class Way {
  Static,    ///< none: the ball does not move
  Rest,      ///< a motion from the place to itself
  Anywhere,  ///< from the place to one Anywhere
  Start,     ///< from the place in any direction
  End,       ///< to the place from any direction
  Across,    ///< halfway at the place, perpendicular to the direction of the closest point: grazes, or slides
  Along,     ///< halfway at the place, parallel to an edge
  Through,   ///< halfway in the plane below the place, perpendicular to the plane; the radius is the one that just fits
};

// Vertices of the outer loop. Random simple outlines take time that grows with the cube of the number: a second at
// most.
inline constexpr std::size_t kMostVertices = std::size_t{1} << 17, kMostRandomSimple = 1024;

// Holes. Each keeps clear of all others: a tenth of a second.
inline constexpr std::size_t kMostHoles = 1000;

struct Workload {
  Family family = Family::Star;
  Placement placement = Placement::LatticeFrame;
  BallPlace ball = BallPlace::Anywhere;
  std::size_t vertices = 24;  ///< of the outer loop, as close to this number as the family allows; see require_vertices
  std::size_t holes = 0;      ///< at most kMostHoles
  int doubles = 0;  ///< by how many doubles a Near* or LatticeTangent radius differs from the double of the distance
  double koch_dimension = 1.26;  ///< in (1, 2)
  double origin_distance = 0;    ///< distance of the polygon from the origin, in units of its size
  Way way = Way::Static;
};

struct Sample {
  std::string id;  ///< holds workload, seed and index: all that is needed to draw it again
  Ball ball;
  Polygon polygon;
  std::vector<std::string> tags;
  std::optional<Eigen::Vector3d> to{};  ///< the end of the centre's way, unless the ball is static

  /// Returns the ball, or its motion.
  [[nodiscard]] std::variant<Ball, Motion> question() const;
};

/// Draws sample number `index` of a workload: a function of (workload, seed, index) alone. `exact::validate` accepts
/// every polygon. Ball and polygon are drawn independently: workloads that differ only in `ball` and `doubles` have the
/// same polygons; those that differ only in `doubles` have the same centres.
///
/// Workloads that differ only in `way` have the same polygons, and the same balls at their places.
///
/// Requires rounding to nearest. Cost: 5 to 200 us at 24 vertices.
/// Throws std::invalid_argument if the family cannot provide what the workload asks for.
[[nodiscard]] Sample sample(const Workload& workload, std::uint64_t seed, std::uint64_t index);

[[nodiscard]] std::string_view to_string(Family family);
[[nodiscard]] std::string_view to_string(Placement placement);
[[nodiscard]] std::string_view to_string(BallPlace place);
[[nodiscard]] std::string_view to_string(Way way);
[[nodiscard]] const std::vector<Family>& all_families();
/// Returns the families of these names, in the order of all_families; `all` selects every family. Throws
/// std::invalid_argument, which names the first unknown one.
[[nodiscard]] std::vector<Family> find_families(const std::vector<std::string>& names);
/// Throws std::invalid_argument, which names the option and the limit, if one of these families has no outlines with
/// this number of vertices.
void require_vertices(const std::vector<Family>& families, std::size_t vertices);
/// Returns the names of the families that find_families selects, joined by commas. Throws as it does.
[[nodiscard]] std::string selected_names(const std::vector<std::string>& names);
[[nodiscard]] const std::vector<Placement>& all_placements();
[[nodiscard]] const std::vector<BallPlace>& all_ball_places();
[[nodiscard]] const std::vector<Way>& all_ways();

}  // namespace touchstone::workloads

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/triangle.h"

// What hard cases are drawn of: triangles.cpp, outlines.cpp, balls.cpp.
namespace touchstone::workloads::adversarial {

struct BallAndTriangle {
  Triangle triangle;
  Ball ball;
};

// Each function draws triangles that are hard in one way. Vertices may be equal or collinear; see `is_triangle`.

/// Draws coordinates in [-1, 1) with all their bits.
[[nodiscard]] Triangle general_triangle(Random& random);
/// Draws integers of up to 26 bits; axes and vertices often share coordinates.
[[nodiscard]] Triangle lattice_triangle(Random& random);
/// Draws a third vertex within some doubles of the line through the others, or of one of them.
[[nodiscard]] Triangle needle_triangle(Random& random);
/// Draws a triangle at up to 2^50 sizes from the origin.
[[nodiscard]] Triangle far_triangle(Random& random);
/// Draws coordinates each of its own magnitude, or zero, or equal to that of another vertex.
[[nodiscard]] Triangle triangle_of_all_exponents(Random& random);

/// Returns whether the vertices are not collinear. Exact.
[[nodiscard]] bool is_triangle(const Triangle& triangle);

/// Returns the largest coordinate difference of two vertices.
[[nodiscard]] double size_of(const Triangle& triangle);

/// Draws a double from one of the ranges of exponents of triangle_of_all_exponents.
[[nodiscard]] double number_of_any_exponent(Random& random, int range);
inline constexpr int kExponentRanges = 6;

/// Draws a ball whose radius equals exactly the distance from the plane of the face, the line of an edge, or a vertex,
/// unless a sum in doubles was rounded. Most often that is the nearest feature.
///
/// Half of them lie in an integer frame, by Pythagorean triples and quadruples. The others have edges along axes or in
/// a coordinate plane, and every other coordinate has all its bits.
[[nodiscard]] BallAndTriangle tangent(Random& random);

struct BallAndPolygon {
  Ball ball;
  Polygon polygon;
};

/// Scales everything by one power of two: near the least doubles, near the largest, where squares or products of four
/// lengths leave the range of doubles, or in between. Numbers that become subnormal may be rounded. Returns nothing if
/// a number leaves the range. Throws Rejected if neighbouring vertices become equal.
[[nodiscard]] std::optional<BallAndPolygon> scaled_to_extremes(Random& random, const Ball& ball,
                                                               const Polygon& polygon);

/// Draws a number of magnitude 2^-1074 to 2^-971 or 2^971 to 2^1023, with all or few of its bits, or zero.
[[nodiscard]] double extreme_number(Random& random);

/// Scales each coordinate by a power of two of its own, along one axis at least so that all of them are below 2^-970 or
/// above 2^970. Vertices and centre are scaled alike, or the centre gets numbers of its own. The radius is the exact
/// distance, such a number, or as it was. Returns nothing if that is not a ball and a polygon. Cost: about 0.1 ms.
[[nodiscard]] std::optional<BallAndPolygon> with_extreme_numbers(Random& random, const Ball& ball,
                                                                 const Polygon& polygon);

/// Draws a polygon of any family of workloads, with up to 24 vertices and two holes, in an integer or a rotated frame,
/// at up to 2^20 sizes from the origin. In half of the draws its vertices are moved off the plane, by 2^-52 to 2^-3
/// sizes; a third is scaled to extremes. The ball is drawn as for triangles, tangent on the lattice, or close to a
/// vertex at the origin.
///
/// Returns nothing if the moved loops meet. Cost: about 50 us.
[[nodiscard]] std::optional<BallAndPolygon> draw_outline(Random& random);

// Centres and radii near a change of the answer. They are computed in doubles and long doubles and may miss their
// target: `exact` decides the truth about each case.

/// Draws a centre off the face, an edge, or a vertex of the triangle of an edge (the edge and the vertex before it), at
/// a distance of 2^-40 to 2^4 sizes or zero.
[[nodiscard]] Eigen::Vector3d center_off_feature(Random& random, const Polygon& polygon);
/// Draws a centre on an edge, a vertex or the face, up to rounding or some doubles beside it.
[[nodiscard]] Eigen::Vector3d center_on_polygon(Random& random, const Polygon& polygon);
/// Draws a centre straight above a point of an edge or a vertex, up to some doubles.
[[nodiscard]] Eigen::Vector3d center_above_boundary(Random& random, const Polygon& polygon);

/// Draws a ball whose centre has coordinates of magnitude 2^-1074 to 2^-60, or zero; the radius is zero, the exact
/// distance, or one of these coordinates.
[[nodiscard]] Ball ball_close_to_origin(Random& random, const Polygon& polygon);

/// Returns the distance computed in long doubles, moved by -3 to 3 doubles in half of the draws; in one of eight draws
/// the distance to a vertex or the plane, which need not be the nearest feature. Returns a random length if that is not
/// a finite double.
[[nodiscard]] double radius_at_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);
/// The same with the exact distance, at its cost.
[[nodiscard]] double radius_at_exact_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);

/// Returns the largest coordinate difference from vertex 0.
[[nodiscard]] double size_of(const Polygon& polygon);

}  // namespace touchstone::workloads::adversarial

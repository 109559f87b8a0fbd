// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "../shapes/ball.h"
#include "../shapes/plane.h"
#include "../shapes/polygon.h"
#include "answer.h"

/// The three tests of the thesis and the whole answer in plain floating point, as well as a careful engineer writes
/// them: differences of the input before products, no root or division that a test does not need, touching counts.
///
/// Right wherever the input is farther from every boundary than rounding reaches; nothing says when it is not: that
/// is what `exact` is for. Call these functions in the default state of the floating-point unit: round to nearest, with
/// subnormal numbers. With Scalar = double no intermediate result may leave the normal doubles: sizes from about 1e-50
/// to 1e50 are safe.
///
/// Guarantees, for every input but for what is said (rounded operations commute with these):
///  (1) scaling ball and polygon by a power of two scales point, distance and off_plane and changes nothing else,
///      while no intermediate result leaves the normal numbers;
///  (2) growing r never loses a contact, an edge of edges_hit, or `Intersects`;
///  (3) mirroring in a coordinate plane mirrors `point` and changes nothing else but front and back, while the foot
///      is farther from the boundary than rounding reaches (nearer, it may change its place, and with it the rest).
/// The identities of `exact` hold where the input is far from every boundary.
/// Source: [arshad2008, ch. 4], [ericson2005, 5.1]; crossing number after [haines1994].
namespace touchstone::fast {

/// A polygon with all that does not depend on the ball: supporting plane, lifted vertices, edges, in one Scalar.
///
/// Vertices farther off the supporting plane than rounding explains are lifted onto it; the others stay.
/// Requires a polygon that `exact::validate` accepts. Cost: linear, one pass.
template <class Scalar = double>
class PreparedPolygon {
 public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;  ///< a point or a direction
  /// An edge, from vertex to vertex.
  struct Edge {
    Vector start;           ///< its first vertex
    Vector direction;       ///< from its first to its last vertex
    Scalar length_squared;  ///< of the direction
  };

  /// Prepares it.
  explicit PreparedPolygon(const Polygon& polygon);

  /// The supporting plane, with the Newell sum for a normal.
  [[nodiscard]] const Plane<Scalar>& plane() const { return plane_; }
  /// N.N of that normal.
  [[nodiscard]] Scalar normal_squared() const { return normal_squared_; }
  /// The axis along which vertices are lifted.
  [[nodiscard]] int dropped_axis() const { return dropped_axis_; }
  /// The largest move of a vertex onto the plane; 0 where none was lifted.
  [[nodiscard]] Scalar off_plane() const { return off_plane_; }
  /// Edge i starts at vertex i; loops follow each other as in the polygon.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// The vertex at which edge i ends.
  [[nodiscard]] std::size_t next(std::size_t i) const { return next_[i]; }

 private:
  Plane<Scalar> plane_;
  Scalar normal_squared_;
  int dropped_axis_;
  Scalar off_plane_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> next_;
};

/// Does the ball touch the polygon? Stops at the first certain yes or no.
template <class Scalar>
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Ball against polygon; `Touching` where the rounded distances are equal.
template <class Scalar>
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 1: the sign of s^2 - r^2 N.N. Constant cost.
template <class Scalar>
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 2: the foot of the perpendicular against the loops by crossing number; `Boundary` where a rounded
/// orientation is zero. Linear cost.
template <class Scalar>
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 3: the edges at distance <= r from the centre, ascending. Linear cost, no division.
template <class Scalar>
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Every key of the contract. Linear cost.
template <class Scalar>
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// @{
/// The same questions on a polygon asked about once, in doubles.
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

}  // namespace touchstone::fast

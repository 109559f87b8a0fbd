// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "../shapes/ball.h"
#include "../shapes/polygon.h"
#include "answer.h"

namespace touchstone {

/// A supporting plane: the points x with normal.(x - point) = 0. The normal points to its front.
///
/// The normal need not have length 1: to normalise it would cost a root and a rounding that no test needs.
template <class Scalar>
struct Plane {
  Eigen::Matrix<Scalar, 3, 1> normal;  ///< not zero
  Eigen::Matrix<Scalar, 3, 1> point;   ///< any point of the plane
};

/// Returns the axis of the normal's component of largest magnitude, the lowest on a tie: the coordinate to drop when
/// projecting the plane to two dimensions. Exact for the given normal. Call it in the default state of the
/// floating-point unit.
template <class Scalar>
[[nodiscard]] int dropped_axis(const Eigen::Matrix<Scalar, 3, 1>& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

}  // namespace touchstone

/// Contact tests and full answers in plain floating point, carefully written: inputs are subtracted before they are
/// multiplied, no test computes a root or a quotient that it does not need, and touching counts.
///
/// Correct unless the input lies within rounding error of a decision boundary. Such inputs may be answered wrongly,
/// without any indication; use `filtered` or `exact` where that matters. Call these functions in the default state of
/// the floating-point unit: round to nearest, with subnormal numbers. With Scalar = double no intermediate result may
/// leave the normal doubles; sizes from about 1e-50 to 1e50 are safe.
///
/// Guarantees, for every input except as stated (rounded operations commute with these):
///  (1) scaling ball and polygon by a power of two scales point, distance, depth and off_plane and changes nothing
///      else, provided that no intermediate result leaves the normal numbers;
///  (2) growing r never loses a contact, an edge of edges_hit, or `Intersects`;
///  (3) mirroring in a coordinate plane mirrors `point` and `contact_normal` (but reverses that of a centre on the
///      polygon), swaps front and back, and changes nothing else, provided that the foot is not within rounding error
///      of the boundary (there its location, and with it the rest, may change);
///  (4) `contact` is right if r differs from the distance by more than `contact_error` of fast_error.h: where doubles
///      err, and by how much at most, is proved there. A search finds failures at a fiftieth of it, random balls at less.
/// The identities of `exact` hold unless the input lies within rounding error of a decision boundary.
/// Source: [arshad2008, ch. 4], [ericson2005, 5.1]; crossing number after [haines1994].
namespace touchstone::fast {

/// A polygon with everything precomputed that does not depend on the ball: supporting plane, lifted vertices and edges,
/// in one Scalar.
///
/// Vertices that lie farther off the supporting plane than rounding explains are lifted onto it. Requires a polygon
/// that `exact::validate` accepts. Cost: linear, one pass.
template <class Scalar = double>
class PreparedPolygon {
 public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;  ///< a point or a direction
  /// An edge.
  struct Edge {
    Vector start;           ///< its first vertex
    Vector direction;       ///< from its first to its last vertex
    Scalar length_squared;  ///< of the direction
  };

  /// Prepares the polygon.
  explicit PreparedPolygon(const Polygon& polygon);

  /// Returns the supporting plane. Its normal is the Newell sum.
  [[nodiscard]] const Plane<Scalar>& plane() const { return plane_; }
  /// Returns N.N for that normal.
  [[nodiscard]] Scalar normal_squared() const { return normal_squared_; }
  /// Returns the axis along which vertices are lifted.
  [[nodiscard]] int dropped_axis() const { return dropped_axis_; }
  /// Returns the largest displacement of a vertex onto the plane; 0 if none was lifted.
  [[nodiscard]] Scalar off_plane() const { return off_plane_; }
  /// Returns the edges. Edge i starts at vertex i of the polygon.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Returns the vertex at which edge i ends.
  [[nodiscard]] std::size_t next(std::size_t i) const { return next_[i]; }

 private:
  Plane<Scalar> plane_;
  Scalar normal_squared_;
  int dropped_axis_;
  Scalar off_plane_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> next_;
};

/// Returns whether the ball touches the polygon. Stops as soon as the answer is known.
template <class Scalar>
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Returns the distance against the radius: `Touching` if they are equal after rounding.
template <class Scalar>
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 1: returns the side of the supporting plane, by the sign of s^2 - r^2 N.N. Cost: constant.
template <class Scalar>
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 2: returns where the foot of the perpendicular lies, by crossing number; `Boundary` if a rounded orientation is
/// zero. Cost: linear.
template <class Scalar>
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 3: returns the edges at distance <= r from the centre, ascending. Cost: linear, without a division.
template <class Scalar>
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Returns the full answer. Cost: linear.
template <class Scalar>
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// @{
/// The same for a polygon that is queried only once, in doubles: prepares it first.
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

}  // namespace touchstone::fast

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/triangle.h"

/// Exact answers, which define what is correct: the functions of `fast` over an exact kernel of CGAL.
///
/// Every answer is that of exact real arithmetic on the given doubles. `point`, `distance`, `contact_normal`, `depth`
/// and `off_plane` are the doubles nearest to the exact values (ties to even; infinite beyond the finite doubles). All
/// finite doubles are valid input, subnormal ones included. The answers do not depend on the caller's rounding mode or
/// flush-to-zero setting. These are left as found, as are the INVALID, OVERFLOW and DIVBYZERO flags.
///
/// Guarantees, for every ball and every polygon that `validate` accepts:
///  (1) rotating the start of a loop, or reordering holes, renumbers edges and vertices and changes nothing else,
///      except which of several nearest features has the lowest index, and `point` with it;
///  (2) reversing the outer loop swaps InFront and Behind, and reverses `contact_normal` if the centre is on the
///      polygon; reversing a hole does not; apart from the renumbering, as in (1), nothing else changes;
///  (3) mirroring in a coordinate plane or exchanging two axes mirrors `point` and `contact_normal`, swaps InFront and
///      Behind, reverses `contact_normal` if the centre is on the polygon, and changes nothing else, unless a tie
///      decides the dropped axis;
///  (4) scaling by a power of two scales `point`, `distance`, `depth` and `off_plane` and changes nothing else,
///      provided that no number leaves the normal doubles;
///  (5) a translation that is exact in every coordinate moves `point` (which is rounded again) and changes nothing
///      else;
///  (6) growing r never loses a contact, an edge of edges_hit, or Intersects, and never lessens `depth`;
///  (7) ball and polygon are closed: if the distance d is a double, r = d is Touching, the double below d is Separate
///      and the double above d is Overlapping;
///  (8) the parts agree: contact if and only if the plane is Intersects and the foot is not Outside, or an edge is hit;
///      foot Inside <=> nearest is the face; contact => plane Intersects;
///  (9) the answers equal those of `fast` unless the input lies within rounding error of a decision boundary;
/// (10) a hole is a difference of regions: for a hole H in the region P, in the plane of P, the foot is in (P without
///      H) if and only if it is in P and not inside H, and on the boundary if it is on either boundary; the edges hit
///      are those of P, then those of H;
/// (11) `depth` is 0 for Touching, at most 0 for Separate, at least 0 for Overlapping; `contact_normal` has a length of
///      1 to within 2^-53, and a centre that moves along it from the face keeps `point` and `contact_normal`.
/// Source: [arshad2008, ch. 4]; kernel [cgal2022].
namespace touchstone::exact {

/// A polygon lifted exactly onto its supporting plane.
///
/// Throws Rejected with `zero-normal` if there is no such plane. Requires that the loops neither cross nor overlap, as
/// `validate` decides. Cost: linear, about 1 us per vertex.
class PreparedPolygon {
 public:
  /// Prepares the polygon.
  explicit PreparedPolygon(const Polygon& polygon);
  /// Prepares the triangle, which may be degenerate, or a Segment: then every ball intersects the plane, the foot is
  /// outside, and `contact_normal` is 0 where the centre is on it.
  explicit PreparedPolygon(const Triangle& triangle);
  /// @{
  /// A moved-from object may only be assigned to or destroyed.
  PreparedPolygon(PreparedPolygon&&) noexcept;
  PreparedPolygon& operator=(PreparedPolygon&&) noexcept;
  /// @}
  ~PreparedPolygon();

  struct Lifted;  ///< internal

 private:
  friend const Lifted& lifted(const PreparedPolygon& polygon);
  std::unique_ptr<const Lifted> lifted_;
};

/// Returns whether the ball touches the polygon.
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon);
/// Returns the distance against the radius: > is Separate, = is Touching, < is Overlapping.
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon);
/// Test 1: returns the side of the supporting plane on which the ball lies.
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon);
/// Test 2: returns where the foot of the perpendicular lies with respect to the lifted loops.
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon);
/// Test 3: returns the lifted edges at distance <= r from the centre, ascending.
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon);
/// Returns the full answer.
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon);

/// Returns which of two polygons is nearer to the ball's centre: the first (-1), neither (0) or the second (+1).
[[nodiscard]] int compare_distances(const Ball& ball, const PreparedPolygon& first, const PreparedPolygon& second);

/// @{
/// The same for a polygon that is queried only once: prepares it first.
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

/// @{
/// The same for a triangle, which may be degenerate, or a Segment.
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle);
[[nodiscard]] Relation relation(const Ball& ball, const Triangle& triangle);
[[nodiscard]] ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle);
/// @}

}  // namespace touchstone::exact

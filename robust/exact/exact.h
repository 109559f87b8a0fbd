// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/polygon.h"

/// The statement of the truth: the questions of `fast` over a CGAL exact kernel.
///
/// Every answer is that of the exact real numbers that the doubles are; `point`, `distance` and `off_plane` are the
/// doubles nearest to the exact values (ties to even; infinite beyond the finite doubles). All finite doubles are
/// legal, subnormal ones too. The answers do not depend on the caller's rounding mode or flush-to-zero setting,
/// which are left as found, as are the INVALID, OVERFLOW and DIVBYZERO flags.
///
/// Guarantees, for every ball and every polygon that `validate` accepts:
///  (1) rotating the start of a loop, or reordering holes, renumbers edges and vertices and changes nothing else,
///      but which of several nearest features has the lowest index, and `point` with it;
///  (2) reversing the outer loop swaps InFront and Behind; reversing a hole does not; apart from the renumbering,
///      as in (1), nothing else changes;
///  (3) mirroring in a coordinate plane or exchanging two axes mirrors `point`, swaps InFront and Behind, and changes
///      nothing else, where no tie decides the dropped axis;
///  (4) scaling by a power of two scales `point`, `distance` and `off_plane` and changes nothing else, while no
///      number leaves the normal doubles;
///  (5) a translation that is exact in every coordinate moves `point` (rounded anew) and changes nothing else;
///  (6) growing r never loses a contact, an edge of edges_hit, or Intersects;
///  (7) closed: r = d is Touching, r one double less is Separate, one double more Overlapping, wherever d is a double;
///  (8) together: contact if and only if the plane is Intersects and the foot is not Outside, or an edge is hit;
///      foot Inside <=> nearest is the face; contact => plane Intersects;
///  (9) equal to `fast` wherever the input is far from every boundary;
/// (10) a hole is a difference of regions: with hole H in the region P, and in its plane, the foot is in (P without H)
///      exactly where it is in P and not inside H, boundary in either's boundary; the edges hit are those of P, then
///      those of H.
/// Source: [arshad2008, ch. 4]; kernel [cgal2022].
namespace touchstone::exact {

/// A polygon lifted exactly onto its supporting plane.
///
/// Throws Rejected with `zero-normal` where there is no such plane; that the loops are simple and do not meet is
/// required (`validate` decides it). Cost: linear; about 1 us a vertex.
class PreparedPolygon {
 public:
  /// Prepares it.
  explicit PreparedPolygon(const Polygon& polygon);
  /// @{
  /// One that was moved from may only be assigned to or destroyed.
  PreparedPolygon(PreparedPolygon&&) noexcept;
  PreparedPolygon& operator=(PreparedPolygon&&) noexcept;
  /// @}
  ~PreparedPolygon();

  struct Lifted;  ///< what was prepared, for the functions of this namespace: exact.cpp

 private:
  friend const Lifted& lifted(const PreparedPolygon& polygon);
  std::unique_ptr<const Lifted> lifted_;
};

/// Does the ball touch the polygon?
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon);
/// Distance against radius: > is Separate, = Touching, < Overlapping.
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon);
/// Test 1: the ball against the supporting plane.
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon);
/// Test 2: the foot of the perpendicular against the lifted loops.
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon);
/// Test 3: the lifted edges at distance <= r from the centre, ascending.
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon);
/// Every key of the contract.
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon);

/// Which of two polygons is nearer to the ball's centre: the first (-1), neither (0), the second (+1).
[[nodiscard]] int compare_distances(const Ball& ball, const PreparedPolygon& first, const PreparedPolygon& second);

/// @{
/// The same questions on a polygon asked about once.
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

}  // namespace touchstone::exact

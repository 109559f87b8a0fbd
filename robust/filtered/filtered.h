// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "../../geometry/contact/answer.h"
#include "../../geometry/shapes/ball.h"
#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/triangle.h"
#include "stage.h"

/// The answers of `exact` at about the price of `fast`.
///
/// Every question is first asked in plain doubles with proved error bounds. What those leave unsure, and only where it
/// can still change the answer asked for, goes on to stages that are slower and surer, the last of which decides every
/// finite input. `point` and `distance` are correctly rounded: the same bits on every machine. The answers do not
/// depend on the caller's rounding mode or flush-to-zero setting, which are left as found, as are the INVALID,
/// OVERFLOW and DIVBYZERO flags; their traps may be unmasked. The first stage works in the caller's state and raises
/// INEXACT, UNDERFLOW and, on x86, denormal-operand exceptions: a caller who has unmasked a trap of one of these is
/// trapped, as by SIGFPE. Up to the last stage nothing is allocated but the list that `edges_hit` returns.
///
/// Guarantees, for every ball and every polygon that `exact::validate` accepts:
///  (1) each answer equals that of the function of the same name in `exact`, and so keeps all its identities;
///  (2) a batch gives what single questions give, in the same order;
///  (3) the answers are the same with and without vector instructions; only stages and times differ.
/// Bounds: robust/filtered/detail/bounds.h, proved in robust/proofs. Source: [shewchuk1997], [melquiond2007],
/// [joldes2017].
namespace touchstone::filtered {

/// A polygon with all that does not depend on the ball: exact normal, an isometric frame in its plane with proved
/// bounds, edges as structure of arrays, and a hierarchy of boxes over them.
///
/// Throws Rejected with `zero-normal` where there is no supporting plane; that the loops are simple and do not meet is
/// required (`exact::validate` decides it). Cost: O(n log n), 1 to 3 us a vertex; then a query about a small ball
/// costs about O(log n) where a small disc meets few edges; memory: O(n), or O(n log n) for loops that wind through
/// every part of the plane.
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

  struct Parts;  ///< what was prepared, for the library's own functions: detail/prepared.h

 private:
  friend const Parts& parts_of(const PreparedPolygon& polygon);
  std::unique_ptr<const Parts> parts_;
};

/// Does the ball touch the polygon? The foot, distances and features are looked at only where they can decide it.
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon);
/// Distance against radius: > is Separate, = Touching, < Overlapping.
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon);
/// Test 1: the ball against the supporting plane. Constant cost.
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon);
/// Test 2: the foot of the perpendicular against the lifted loops.
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon);
/// Test 3: the lifted edges at distance <= r from the centre, ascending.
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon);
/// Every key of the contract.
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon);

/// @{
/// The same questions; `counts` is told which stages decided.
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
/// @}

/// @{
/// The same questions on a polygon asked about once.
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

/// @{
/// Does the ball touch the triangle? Nothing is prepared. Constant cost, a little more than that of `fast::contact`.
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle);
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts);
/// @}

/// The point of a triangle that is closest to a centre.
struct ClosestPoint {
  Feature feature;        ///< that holds it
  Eigen::Vector3d point;  ///< as Answer has it
  double distance;        ///< likewise

  friend bool operator==(const ClosestPoint& a, const ClosestPoint& b) {
    return a.feature == b.feature && same_point(a.point, b.point) && same_number(a.distance, b.distance);
  }
};

/// @{
/// As `answer` has them. Nothing is prepared. Constant cost, about 0.5 us.
[[nodiscard]] ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle);
[[nodiscard]] ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle, StageCounts& counts);
/// @}

/// Many balls against one polygon: touches[i] says whether balls[i] does. Throws std::invalid_argument for spans of
/// different lengths.
void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches);
/// One ball against many triangles: touches[i] says whether it touches triangles[i]. Throws as above.
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches);

}  // namespace touchstone::filtered

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
/// Every query is first evaluated in plain doubles with proved error bounds. Decisions that these bounds leave open are
/// passed on, if they can still change the answer, to slower and more precise stages; the last stage decides every
/// finite input. `point`, `distance`, `contact_normal` and `depth` are correctly rounded: their bits depend on neither
/// processor nor compiler.
///
/// The answers do not depend on the caller's rounding mode or flush-to-zero setting. These are left as found, as are
/// the INVALID, OVERFLOW and DIVBYZERO flags, whose traps may be unmasked. The first stage runs in the caller's state
/// and raises INEXACT, UNDERFLOW and, on x86, denormal-operand exceptions: a caller who has unmasked a trap for one of
/// these receives it, as SIGFPE for instance. Before the last stage nothing is allocated except the list that
/// `edges_hit` returns, what a PreparedPolygon makes on demand, and what functions that take a Polygon prepare.
///
/// Guarantees, for every ball and every polygon that `exact::validate` accepts:
///  (1) each answer equals that of the function of the same name in `exact`, and so satisfies all its identities;
///  (2) a batch returns the answers of single queries, in the same order;
///  (3) the answers are the same with and without vector instructions; only stages and times differ.
/// Bounds: robust/filtered/detail/signs/bounds.h, proved in robust/proofs. Source: [shewchuk1997], [melquiond2007],
/// [joldes2017].
namespace touchstone::filtered {

/// A polygon with everything precomputed that does not depend on the ball: an isometric frame in its plane with proved
/// bounds, and its edges in that frame as structure of arrays.
///
/// What few queries need is made for the first of them: the exact normal and lifts, 1 to 3 us per vertex, for decisions
/// that plain doubles leave open; and a hierarchy of boxes over more than 32 edges, O(n log n), 0.2 to 0.4 us per
/// vertex. Several threads may query at once.
///
/// Throws Rejected with `zero-normal` if there is no supporting plane. Requires that the loops neither cross nor
/// overlap, as `exact::validate` decides. Cost: O(n), 2 to 6 times that of fast::PreparedPolygon; 1 to 3 us per vertex
/// if scaling to the polygon's size loses bits, or if the two largest components of the normal agree to more than 126
/// bits. A query with a small ball then costs about O(log n), if small discs meet few edges. Memory: O(n), or
/// O(n log n) for loops that wind through every part of the plane.
class PreparedPolygon {
 public:
  /// Prepares the polygon.
  explicit PreparedPolygon(const Polygon& polygon);
  /// @{
  /// A moved-from object may only be assigned to or destroyed.
  PreparedPolygon(PreparedPolygon&&) noexcept;
  PreparedPolygon& operator=(PreparedPolygon&&) noexcept;
  /// @}
  ~PreparedPolygon();

  /// Precomputes everything that queries would otherwise build on demand. Later queries then allocate nothing before
  /// the last stage, and the first takes no longer than the next. Cost: 2 to 5 us per vertex.
  void complete() const;

  struct Parts;  ///< internal

 private:
  friend const Parts& parts_of(const PreparedPolygon& polygon);
  std::unique_ptr<const Parts> parts_;
};

/// Returns whether the ball touches the polygon. Evaluates foot, distances and features only if needed.
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon);
/// Returns the distance against the radius: > is Separate, = is Touching, < is Overlapping.
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon);
/// Test 1: returns the side of the supporting plane on which the ball lies. Cost: constant.
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon);
/// Test 2: returns where the foot of the perpendicular lies with respect to the lifted loops.
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon);
/// Test 3: returns the lifted edges at distance <= r from the centre, ascending.
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon);
/// Returns the full answer.
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon);

/// @{
/// The same; `counts` also receives which stages decided.
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] Relation relation(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
[[nodiscard]] Answer answer(const Ball& ball, const PreparedPolygon& polygon, StageCounts& counts);
/// @}

/// @{
/// The same for a polygon that is queried only once. Builds no hierarchy. Cost: O(n).
[[nodiscard]] bool contact(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Relation relation(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const Polygon& polygon);
[[nodiscard]] PointLocation foot(const Ball& ball, const Polygon& polygon);
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const Polygon& polygon);
[[nodiscard]] Answer answer(const Ball& ball, const Polygon& polygon);
/// @}

/// @{
/// Returns whether the ball touches the triangle, which may be degenerate or a Segment, as below. Needs no preparation.
/// Cost: constant, little more than that of `fast::contact`; 0.1 us for a degenerate triangle, 3 us if three different
/// vertices lie on one line.
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle);
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle, StageCounts& counts);
/// @}

/// Returns the distance against the radius, as above. Cost: that of `closest`; 10 us if depth rounds to 0.
[[nodiscard]] Relation relation(const Ball& ball, const Triangle& triangle);

using touchstone::ClosestPoint;

/// @{
/// Returns the closest point, its feature, its distance and its contact normal, as in `answer`. Needs no preparation.
/// Cost: constant, about 0.5 us.
[[nodiscard]] ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle);
[[nodiscard]] ClosestPoint closest(const Eigen::Vector3d& center, const Triangle& triangle, StageCounts& counts);
/// @}

/// Writes to touches[i] whether balls[i] touches the polygon. Throws std::invalid_argument if the spans differ in
/// length.
void contact(std::span<const Ball> balls, const PreparedPolygon& polygon, std::span<bool> touches);
/// Writes to touches[i] whether the ball touches triangles[i]. Throws std::invalid_argument if the spans differ in
/// length.
void contact(const Ball& ball, std::span<const Triangle> triangles, std::span<bool> touches);

}  // namespace touchstone::filtered

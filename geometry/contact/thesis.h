// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "../shapes/ball.h"
#include "../shapes/polygon.h"
#include "answer.h"

/// The method of the thesis, unchanged: the historical reference, without tolerances and without repairs.
///
/// Labels: [T] the thesis states it; [S] a public source states it, a lesson whose steps match the thesis; [D] derived;
/// [C] chosen here, because neither states it. That the thesis programs this lesson is [D]: likely, but not confirmed.
///
/// The method, for a ball (C, r) and a loop P0, P1, ...
///  (1) N = unit((P2 - P0) x (P1 - P0)), from the first three vertices only [S]; its front is the back of the
///      counter-clockwise rule [D];
///  (2) s = N.C + D with D = -N.P0; |s| < r intersects the plane [T, S], else s >= r is in front [S], else behind [S];
///  (3) Q = C - s N is inside if the angles at which the edges are seen from Q add up to 0.99 x 2 pi or more [S];
///  (4) otherwise an edge must come nearer to C than r [T, S].
/// Neither [T] nor [S] knows holes. [C]: inside means inside the outer loop and inside none of the holes; all edges
/// count.
///
/// Known errors [D], each measured in tests/experiments/thesis/figures:
///  - the unsigned angles around a point outside a non-convex loop can also exceed 2 pi: the notch of a U counts as
///  inside;
///  - the factor 0.99 accepts points up to L / (2 tan 89.1 deg) = 0.00785 L outside the middle of an edge of length L,
///    and excludes as much around a hole;
///  - near an edge u.v / |u||v| can round below -1: acos is NaN, and the angle counts as 0;
///  - if the first three vertices are collinear, N is NaN, every comparison is false and every contact is missed;
///  - far from the origin s is a small difference of large numbers;
///  - touching does not count as contact.
/// In exact arithmetic and without holes nothing else is missed: inside a simple loop the signed angles add up to
/// +-2 pi, so their magnitudes add up to no less.
///
/// Vectors are in Scalar (float in [S]), the sum of angles is in double [S]. Call these functions in the default state
/// of the floating-point unit. acos and atan2 come from the C library, so last bits may differ between C libraries.
/// Source: [arshad2008, 4.2], [gametutorials].
namespace touchstone::thesis {

/// Whether angles are summed unsigned or with the sign of N.(u x v). The magnitude of the sum is compared.
enum class Angles { Unsigned, Signed };
/// How the angle between u and v is computed: acos(u.v / |u||v|), or atan2(|u x v|, u.v).
enum class Arc { Cosine, Tangent };
/// Which normal is used: that of step (1), or the unit Newell sum of the outer loop, whose front is that of the
/// contract.
enum class Normal { FirstThreeVertices, Newell };
/// Whether touching the plane or an edge counts.
enum class Comparison { Strict, Closed };

/// Variants of the method, each of which removes one error. The defaults are [S]; all other values are [C].
struct Options {
  double match_factor = 0.99;                  ///< the share of 2 pi from which a sum of angles means inside
  Angles angles = Angles::Unsigned;            ///< in step (3)
  Arc arc = Arc::Cosine;                       ///< in step (3)
  Normal normal = Normal::FirstThreeVertices;  ///< in step (1)
  Comparison comparison = Comparison::Strict;  ///< in steps (2) and (4)
};

/// A polygon with everything precomputed that does not depend on the ball. [S] recomputes it for each ball, to the same
/// bits.
///
/// Loops are used as given: nothing is lifted onto the plane [S]. Cost: linear, one root per edge. Instantiated for
/// float and double.
template <class Scalar = double>
class PreparedPolygon {
 public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;  ///< a point or a direction
  /// An edge.
  struct Edge {
    /// @{
    /// Its ends, as in the polygon.
    Vector start, end;
    /// @}
    Vector direction;  ///< of length 1; NaN if start and end are equal in Scalar
    Scalar length;     ///< from start to end
  };

  /// Prepares the polygon for this variant of the method.
  explicit PreparedPolygon(const Polygon& polygon, const Options& options = {});

  /// Returns the variant.
  [[nodiscard]] const Options& options() const { return options_; }
  /// Returns N, of length 1 or NaN.
  [[nodiscard]] const Vector& normal() const { return normal_; }
  /// Returns D: the plane is N.x + D = 0.
  [[nodiscard]] Scalar offset() const { return offset_; }
  /// Returns the edges. Edge i starts at vertex i of the polygon.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Returns one past the last edge of each loop, the outer loop first.
  [[nodiscard]] const std::vector<std::size_t>& loop_ends() const { return loop_ends_; }

 private:
  Options options_;
  Vector normal_;
  Scalar offset_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> loop_ends_;
};

/// Test 1 [T, 4.2.1]: returns the result of step (2); `Behind` if N is NaN. Cost: constant.
template <class Scalar>
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 2 [T, 4.2.2]: returns the result of step (3), `Inside` or `Outside`; this method has no `Boundary`. Cost:
/// linear, one acos per edge.
template <class Scalar>
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 3 [T, 4.2.3]: returns the edges for which step (4) holds, ascending, whatever the other tests say. Cost:
/// linear, one root per edge.
template <class Scalar>
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Returns whether the ball touches the polygon [T, 4.2; S]: tests the plane, then the foot, then the edges, and stops
/// as soon as the answer is known.
template <class Scalar>
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

}  // namespace touchstone::thesis

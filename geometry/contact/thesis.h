// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "../shapes/ball.h"
#include "../shapes/polygon.h"
#include "answer.h"

/// The thesis's own method, as it was: the historical reference, with no tolerance and no care added.
///
/// Labels: [T] the thesis says so; [S] a public source, the lesson that its steps match, says so; [D] derived;
/// [C] chosen here, because neither says. That the lesson is what the thesis programs is [D]: strong, not confirmed.
///
/// The method, for a ball (C, r) and a loop P0, P1, ...
///  (1) N = unit((P2 - P0) x (P1 - P0)): from the first three vertices alone [S], so the front is the back of the
///      counter-clockwise rule [D];
///  (2) s = N.C + D with D = -N.P0; |s| < r intersects the plane [T, S], else s >= r is in front [S], else behind [S];
///  (3) Q = C - s N is inside if the angles at which the edges are seen from Q add up to 0.99 x 2 pi or more [S];
///  (4) otherwise an edge must come nearer to C than r [T, S].
/// Holes are unknown to [T] and [S]; [C]: inside is inside the outer loop and inside no hole, and all edges count.
///
/// Known errors [D], each measured in tests/thesis:
///  - the unsigned angles around a point outside a non-convex loop can exceed 2 pi too: the notch of a U is inside;
///  - the factor 0.99 takes in points up to L / (2 tan 89.1 deg) = 0.00785 L outside the middle of an edge of length L,
///    and, around a hole, gives as much away;
///  - u.v / |u||v| rounds below -1 near an edge, acos is NaN, the angle counts as 0;
///  - first three vertices on a line: N is NaN, every comparison false, every contact missed;
///  - far from the origin s is a small difference of large numbers;
///  - touching is no contact.
/// Without holes nothing else is missed in exact arithmetic: inside a simple loop the angles, signed, add up to
/// +-2 pi, so their magnitudes to no less.
///
/// Vectors are in Scalar (float in [S]), the sum of angles in double [S]. Call these functions in the default state of
/// the floating-point unit; acos and atan2 are the C library's, so that last bits may differ between libraries.
/// Source: [arshad2008, 4.2], [gametutorials].
namespace touchstone::thesis {

/// The angles as they are, or with the sign of N.(u x v); then the magnitude of their sum is compared.
enum class Angles { Unsigned, Signed };
/// The angle between u and v: acos(u.v / |u||v|), or atan2(|u x v|, u.v).
enum class Arc { Cosine, Tangent };
/// The normal: step (1), or the unit Newell sum of the outer loop, which has the front of the contract.
enum class Normal { FirstThreeVertices, Newell };
/// Whether touching, of the plane or of an edge, counts.
enum class Comparison { Strict, Closed };

/// What is varied, one error at a time. The defaults are [S]; every other value is [C].
struct Options {
  double match_factor = 0.99;                  ///< the share of 2 pi from which a sum of angles means inside
  Angles angles = Angles::Unsigned;            ///< in step (3)
  Arc arc = Arc::Cosine;                       ///< in step (3)
  Normal normal = Normal::FirstThreeVertices;  ///< in step (1)
  Comparison comparison = Comparison::Strict;  ///< in steps (2) and (4)
};

/// A polygon with all that does not depend on the ball. [S] computes it again for each ball, to the same bits.
///
/// Loops are taken as they are: nothing is lifted onto the plane [S]. Cost: linear, one root an edge.
/// Instantiated for float and double.
template <class Scalar = double>
class PreparedPolygon {
 public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;  ///< a point or a direction
  /// An edge, from vertex to vertex.
  struct Edge {
    /// @{
    /// As the polygon has them.
    Vector start, end;
    /// @}
    Vector direction;  ///< of length 1; NaN where start and end are equal in Scalar
    Scalar length;     ///< from start to end
  };

  /// Prepares it for the method as varied.
  explicit PreparedPolygon(const Polygon& polygon, const Options& options = {});

  /// What is varied.
  [[nodiscard]] const Options& options() const { return options_; }
  /// N, of length 1 or NaN.
  [[nodiscard]] const Vector& normal() const { return normal_; }
  /// D: the plane is N.x + D = 0.
  [[nodiscard]] Scalar offset() const { return offset_; }
  /// Edge i starts at vertex i; loops follow each other as in the polygon.
  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// One past the last edge of each loop, the outer loop first.
  [[nodiscard]] const std::vector<std::size_t>& loop_ends() const { return loop_ends_; }

 private:
  Options options_;
  Vector normal_;
  Scalar offset_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> loop_ends_;
};

/// Test 1 [T, 4.2.1]: step (2). `Behind` where N is NaN. Constant cost.
template <class Scalar>
[[nodiscard]] PlaneSide plane_side(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 2 [T, 4.2.2]: step (3), `Inside` or `Outside`: this method knows no boundary. Linear cost, one acos an edge.
template <class Scalar>
[[nodiscard]] PointLocation foot(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// Test 3 [T, 4.2.3]: step (4) for every edge, whatever the other tests say: indices, ascending. Linear cost, one root
/// an edge.
template <class Scalar>
[[nodiscard]] std::vector<std::size_t> edges_hit(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

/// The whole pipeline [T, 4.2; S]: the plane, then the foot, then the edges, stopping at the first answer.
template <class Scalar>
[[nodiscard]] bool contact(const Ball& ball, const PreparedPolygon<Scalar>& polygon);

}  // namespace touchstone::thesis

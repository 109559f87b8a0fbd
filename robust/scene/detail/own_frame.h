// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/detail/numbers/vector3.h"

/// Triangles under a pose that stay in their own frame: a ball comes to them, and a triangle is posed only when that
/// does not decide.
namespace touchstone::scene::detail {

/// Returns the triangle with its vertices posed, as scene::posed does, without looking at the result. Requires finite
/// numbers, and round to nearest without flush-to-zero.
[[nodiscard]] Triangle posed_vertices(const Pose& pose, const Triangle& triangle);

/// The constants of OwnFrame; u = 2^-53 is the error of one operation. Proved in
/// tests/robust/proofs/own_frame_test.cpp.
namespace own_frame {

/// Covers the rounding of A R - I and R A - I, summed over a row or a column, and that of the entries of A.
inline constexpr double kResidual = 10 * 0x1p-53;
/// A centre in the own frame is known to kCenter |A| D, where D is the sum of the components of c - t. Lengths under
/// the pose that follow from it are known to kCenter D.
inline constexpr double kCenter = 4.25 * 0x1p-53;
/// A posed vertex is known to kRounding times the largest of its coordinates, plus kTiny. The latter is also more than
/// what any other length here loses to underflow.
inline constexpr double kRounding = 1.75 * 0x1p-53;
inline constexpr double kTiny = 0x1p-900;
/// Cover the rounding of each length that is computed from these.
inline constexpr double kWide = 1 + 0x1p-48, kNarrow = 1 - 0x1p-48;
/// Covers what a length loses if the squares of its components underflow.
inline constexpr double kTinyLength = 0x1p-500;
/// The length of a triangle's computed normal is off by at most kNormal times the square of the longest side, besides
/// its own rounding. Sides are from kShortest to kLongest.
inline constexpr double kNormal = 0x1p-48, kShortest = 0x1p-240, kLongest = 0x1p240;
/// The limits for the residual, for lengths of models and poses, and for the coordinates of centres.
inline constexpr double kMostResidual = 0x1p-20;
inline constexpr double kLargest = 0x1p60;
inline constexpr double kLargestOfCenters = 0x1p500;

// Over any numbers: doubles; for the proofs, numbers that count their roundings or carry the bounds of their errors.

/// Returns an entry of a product of two matrices.
template <class A, class B>
constexpr auto entry(const filtered::detail::Vector3<A>& row, const filtered::detail::Vector3<B>& column) {
  return dot(row, column);
}
/// Returns a coordinate of A (c - t).
template <class A, class N>
constexpr auto coordinate(const filtered::detail::Vector3<A>& row, const filtered::detail::Vector3<N>& center,
                          const filtered::detail::Vector3<N>& t) {
  return dot(row, filtered::detail::Vector3{center.x - t.x, center.y - t.y, center.z - t.z});
}
/// Returns D.
template <class N>
constexpr auto spread(const filtered::detail::Vector3<N>& center, const filtered::detail::Vector3<N>& t) {
  using filtered::detail::magnitude;
  return magnitude(center.x - t.x) + magnitude(center.y - t.y) + magnitude(center.z - t.z);
}

/// Bounds that depend on the pose alone.
template <class N>
struct Lengths {
  N longer, shorter;  ///< of |R| and |A|
  N rounding;         ///< e
  N margin;           ///< |A| e + h reach
};
/// `translation`: the largest component of t.
template <class N>
constexpr Lengths<N> lengths(const N& scale, const N& residual, const N& reach, const N& translation) {
  using filtered::detail::constant;
  const N wide = constant<N>(kWide), stretch = constant<N>(1) + residual;
  const N longer = stretch * scale * wide, shorter = stretch / scale * wide;
  const N rounding = (constant<N>(kRounding) * (longer * reach + translation) + constant<N>(kTiny)) * wide;
  return {longer, shorter, rounding, (shorter * rounding + residual * reach) * wide};
}

/// Returns the radius in the own frame of a ball that holds all that a ball of this radius holds under the pose.
template <class N>
constexpr N outer_radius(const N& radius, const Lengths<N>& lengths, const N& spread) {
  using filtered::detail::constant;
  const N off = lengths.margin + constant<N>(kCenter) * lengths.shorter * spread;
  return (lengths.shorter * radius + off) * constant<N>(kWide);
}
/// Returns how much farther than |R| times its distance in the own frame a triangle may be from a centre.
template <class N>
constexpr N lost(const Lengths<N>& lengths, const N& residual, const N& spread) {
  using filtered::detail::constant;
  return (lengths.rounding + (residual + constant<N>(kCenter)) * spread) * constant<N>(kWide);
}
/// Returns the radius in the own frame of a ball that holds only what a ball of this radius holds under the pose.
template <class N>
constexpr N inner_radius(const N& radius, const Lengths<N>& lengths, const N& lost) {
  return (radius - lost) * filtered::detail::constant<N>(kNarrow) / lengths.longer;
}
/// Returns the radius under the pose of a ball that holds all that a ball of this radius holds in the own frame.
template <class N>
constexpr N radius_under_pose(const N& radius, const Lengths<N>& lengths, const N& lost) {
  return (lengths.longer * radius + lost) * filtered::detail::constant<N>(kWide);
}
/// Returns an altitude, in the own frame, at and below which the rounding of vertices may make a triangle degenerate.
template <class N>
constexpr N thinnest_altitude(const Lengths<N>& lengths, const N& residual) {
  using filtered::detail::constant;
  const N both = lengths.rounding + lengths.rounding;
  return both * lengths.shorter / (constant<N>(1) - residual) * constant<N>(kWide);
}
template <class N>
constexpr N length(const filtered::detail::Vector3<N>& v) {
  using filtered::detail::square_root;
  return square_root(dot(v, v));
}
/// Returns at least the length of a vector.
template <class N>
constexpr N length_at_least(const filtered::detail::Vector3<N>& v) {
  using filtered::detail::constant;
  return (length(v) + constant<N>(kTinyLength)) * constant<N>(kWide);
}
/// Returns at least the sum of two lengths.
template <class N>
constexpr N sum_at_least(const N& a, const N& b) {
  return (a + b) * filtered::detail::constant<N>(kWide);
}
/// Returns by how much the length of a normal may be off.
template <class N>
constexpr N off_normal(const N& longest_side) {
  return filtered::detail::constant<N>(kNormal) * longest_side * longest_side;
}
/// Returns at most the least altitude of a triangle, given a number that is not above twice its area.
template <class N>
constexpr N altitude_at_most(const N& area, const N& longest_side) {
  return area / longest_side * filtered::detail::constant<N>(kNarrow);
}

}  // namespace own_frame

/// A ball as seen from an object's own frame: concentric balls about a centre that is computed.
struct SeenBall {
  Ball outer;    ///< touches every triangle in its own frame that the ball touches under the pose
  double inner;  ///< the radius of a ball that touches such triangles only; negative if no ball does

  [[nodiscard]] Ball inner_ball() const { return {outer.center, inner}; }
};

/// A motion as seen from an object's own frame: both balls move from one centre that is computed to another.
struct SeenMotion {
  Motion
      outer;  ///< touches every triangle in its own frame at every time at which the motion touches it under the pose
  double inner;  ///< the radius of a ball that touches such triangles at such times only; negative if no ball does

  [[nodiscard]] Motion inner_motion() const { return {{outer.ball.center, inner}, outer.to}; }
};

/// The pose of triangles that stay in their own frame.
///
/// R may be any matrix that rounding apart is a rotation or a reflection times a number. A = R^T / s^2 with
/// 3 s^2 = |R|_F^2 is nearly its inverse, and the residual h bounds |A R - I| and |R A - I|. So |R| <= (1 + h) s and
/// |A| <= (1 + h) / s. A point p of a triangle lies at R p + t, moved by the rounding of the vertices by at most e. For
/// the distance of p from A (c - t),
///     |p - A (c - t)| <= |A| (|R p + t - c| + e) + h |p|,
///     |R p + t - c| <= |R| |p - A (c - t)| + h |c - t| + e.
/// Coq proves these inequalities (robust/proofs/coq/own_frame.v).
class OwnFrame {
 public:
  /// Returns the frame for triangles none of whose vertices is farther than `reach` from the origin and none of whose
  /// altitudes is less than `thinnest`, infinite if they may become degenerate; nothing if this pose and these lengths
  /// are beyond the limits above, or if the rounding of vertices may make a triangle degenerate. Requires round to
  /// nearest, without flush-to-zero, as do all functions here.
  ///
  /// No triangle becomes degenerate if 2 e |A| < (1 - h) `thinnest`. If one did, one of its posed vertices would be
  /// between the other two. Then, before rounding, that vertex would be within 2 e of the opposite side. But an
  /// altitude of at least `thinnest` is longer than that under R, as |x| <= |A| |R x| + h |x|.
  [[nodiscard]] static std::optional<OwnFrame> of(const Pose& pose, double reach, double thinnest);

  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] SeenBall seen(const Ball& ball) const;
  /// Sees both ends. In between the seen centre is as far off as on average, weighted by time, and so is what the
  /// bounds above allow for: nowhere farther than at the worse end.
  [[nodiscard]] SeenMotion seen(const Motion& motion) const;
  /// Returns the radius of a ball about `center` that touches, under the pose, each triangle that the ball of this
  /// radius about the seen centre touches in its own frame; infinite for centres beyond the limit.
  [[nodiscard]] double radius_under_pose(const Eigen::Vector3d& center, double radius) const;

 private:
  OwnFrame(const Pose& pose, const Eigen::Matrix3d& inverse, double scale, double residual, double reach);

  Pose pose_;
  Eigen::Matrix3d inverse_;  ///< A
  double residual_;          ///< h
  own_frame::Lengths<double> lengths_;
};

/// Returns at least the distance of the point from the origin.
[[nodiscard]] double distance_from_origin(const Eigen::Vector3d& point);
/// Returns at least the sum of two lengths.
[[nodiscard]] inline double sum_of_lengths(double a, double b) { return own_frame::sum_at_least(a, b); }
/// Returns a lower bound of the triangle's altitudes, 0 if doubles know none. Requires finite vertices.
[[nodiscard]] double least_altitude(const Triangle& triangle);

}  // namespace touchstone::scene::detail

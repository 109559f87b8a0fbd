// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/detail/signs/signs.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"

/// The questions about a triangle that integers of any size and `exact` answer, for every finite input. Apart from the
/// kernels: what is compiled for one machine must not be linked into code for another, and a polygon is not of any
/// target. Requires round to nearest.
namespace touchstone::filtered::detail {

/// Returns the exact sign for an edge. Requires a kind other than Above. Cost: 1 to 10 us.
[[nodiscard]] int bigint_sign(SignKind kind, const BallTriangleView& view, int edge);
/// Returns whether the triangle is degenerate. Cost: about 10 ns if two vertices are equal or doubles find a component
/// of the normal that is not zero, else 3 us.
[[nodiscard]] bool is_degenerate(const double (*vertex)[3]);
/// Returns the sign of the turn from a over b to p, seen against an axis. Cost: about 1 us.
[[nodiscard]] int bigint_turn(const double* a, const double* b, const double* p, int axis);

/// @{
/// Returns the feature that contains the point closest to the centre; a coordinate of the feature's point closest to
/// the centre, or its distance, as the nearest double. Cost: about 10 us.
[[nodiscard]] Feature bigint_nearest(const BallTriangleView& view);
[[nodiscard]] double bigint_point(const BallTriangleView& view, const Feature& feature, int axis);
[[nodiscard]] double bigint_distance(const BallTriangleView& view, const Feature& feature);
/// @}

/// @{
/// Returns the contact normal at the feature's point closest to the centre, or the depth of a ball of this radius, as
/// in Answer. Cost: about 10 us.
[[nodiscard]] Eigen::Vector3d bigint_normal(const BallTriangleView& view, const Feature& feature);
[[nodiscard]] double bigint_depth(const BallTriangleView& view, double radius, const Feature& feature);
/// @}

/// @{
/// Returns the contact, or the first contact, of a moving ball with a triangle, computed by `exact`.
[[nodiscard]] bool exact_motion_contact(const MotionTriangleView& view);
[[nodiscard]] FirstContact exact_first_contact(const MotionTriangleView& view);
/// @}

/// Throws Rejected if exact::validate rejects the triangle as a polygon, or, where degenerate triangles are segments,
/// if it is not finite. Requires round to nearest, without flush-to-zero. Cost: about 10 ns; 2 us if doubles do not
/// find a component of the normal that is certainly not zero.
void expect_valid(const Triangle& triangle, Degenerate degenerate = Degenerate::Refuse);

}  // namespace touchstone::filtered::detail

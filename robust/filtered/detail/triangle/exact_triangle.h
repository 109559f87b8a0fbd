// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/contact/answer.h"
#include "geometry/contact/first_contact.h"
#include "geometry/shapes/triangle.h"
#include "robust/filtered/detail/triangle/ball_triangle_view.h"
#include "robust/filtered/detail/signs/signs.h"

/// The point of a triangle closest to a centre, for every finite input, in integers of any size. Requires round to
/// nearest. Cost: about 10 us each.
namespace touchstone::filtered {

/// Returns the exact sign for an edge of a triangle, for every finite input, in integers of any size. Requires a kind
/// other than Above. Cost: 1 to 10 us.
[[nodiscard]] int bigint_sign(SignKind kind, const BallTriangleView& view, int edge);

/// Returns the feature that contains it.
[[nodiscard]] Feature bigint_nearest(const BallTriangleView& view);
/// Returns a coordinate of the feature's point closest to the centre, or the distance, as the nearest double.
[[nodiscard]] double bigint_point(const BallTriangleView& view, const Feature& feature, int axis);
[[nodiscard]] double bigint_distance(const BallTriangleView& view, const Feature& feature);

/// @{
/// Returns the contact, or the first contact, of a moving ball with a triangle, computed by `exact`.
[[nodiscard]] bool exact_motion_contact(const MotionTriangleView& view);
[[nodiscard]] FirstContact exact_first_contact(const MotionTriangleView& view);
/// @}

/// Throws Rejected if exact::validate rejects the triangle as a polygon. Requires round to nearest, without
/// flush-to-zero. Cost: about 10 ns; 2 us if doubles do not find a component of the normal that is certainly not zero.
void expect_valid(const Triangle& triangle);

}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../../geometry/contact/first_contact.h"
#include "../../geometry/shapes/motion.h"
#include "../../geometry/shapes/polygon.h"
#include "exact.h"

/// Moving balls. Triangles may be degenerate, or a Segment. Each event on the way is the smaller root of a quadratic
/// with exact coefficients. Signs of polynomials compare such roots, so nothing is approximated.
///
/// Guarantees, for every motion and every polygon that `find_fault` and `validate` accept:
///  (1) a ball at rest has the contact of the static answer; its first contact is Start or None;
///  (2) reversing the motion keeps `contact`;
///  (3) if the motion is cut where the centre is a point of doubles, it makes contact if and only if one
///      of the parts does;
///  (4) a ball that touches at any time makes contact; at the first time it touches, and before that it does not;
///  (5) growing r never loses a contact and never makes the first time later;
///  (6) scaling by a power of two, mirroring in a coordinate plane and translations that are exact change nothing but
///      `point`, `contact_normal` and `depth`, as in the static answers; a point that comes along the plane has the
///      normal of the front.
/// Rounding and the floating-point state are those of exact.h. Source: [karavelas2003], [ericson2005, 5.5].
namespace touchstone::exact {

/// @{
/// Returns whether the ball touches the polygon at any time. This is the contact of the capsule, too.
[[nodiscard]] bool contact(const Motion& motion, const PreparedPolygon& polygon);
[[nodiscard]] bool contact(const Motion& motion, const Polygon& polygon);
[[nodiscard]] bool contact(const Motion& motion, const Triangle& triangle);
/// @}

/// @{
/// Returns the first contact. `time`, `depth` and each coordinate of `point` and of `contact_normal` are the doubles
/// nearest to the exact numbers.
[[nodiscard]] FirstContact first_contact(const Motion& motion, const PreparedPolygon& polygon);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Polygon& polygon);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Triangle& triangle);
/// @}

/// Returns which of two polygons the ball touches first: the first (-1), both at the same time or neither (0), or the
/// second (+1). Compares the exact times.
[[nodiscard]] int compare_times(const Motion& motion, const PreparedPolygon& first, const PreparedPolygon& second);

}  // namespace touchstone::exact

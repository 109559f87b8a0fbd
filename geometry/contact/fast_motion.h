// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../shapes/motion.h"
#include "../shapes/triangle.h"
#include "fast.h"
#include "first_contact.h"

/// Moving balls in plain floating point, carefully written: each feature's first time is a root computed without
/// cancellation, from a discriminant that is a difference of two squares of distances. Touching counts.
///
/// Correct unless the input lies within rounding error of a decision boundary; above all, whether a ball grazes or
/// misses is then a matter of luck. Call these functions in the default state of the floating-point unit. With Scalar =
/// double no intermediate result may leave the normal doubles; sizes from about 1e-50 to 1e50 are safe.
///
/// Guarantees
///  (1) contact(M, P) = first_contact(M, P).contact();
///  (2) a first contact is Start if and only if the static `contact` touches; `feature`, `point`, `contact_normal` and
///      `depth` are then those of the static answer;
///  (3) `time` is 0 for Start, infinite for None, and from 0 to 1 for Way: it is never NaN, for any finite input;
///  (4) scaling motion and polygon by a power of two scales `point` and `depth` and changes nothing else, provided that
///      no intermediate result leaves the normal numbers.
/// Source: [ericson2005, 5.5].
namespace touchstone::fast {

/// Returns whether the ball touches the polygon at any time. Stops as soon as the answer is known. Cost: linear.
template <class Scalar>
[[nodiscard]] bool contact(const Motion& motion, const PreparedPolygon<Scalar>& polygon);

/// Returns the first contact. Of several features at equal rounded times it takes the face, then the edge, then the
/// vertex of lowest index. `momentary` needs a discriminant that is rounded to 0. Cost: linear.
template <class Scalar>
[[nodiscard]] FirstContact first_contact(const Motion& motion, const PreparedPolygon<Scalar>& polygon);

/// @{
/// The same for a polygon that is queried only once, in doubles: prepares it first.
[[nodiscard]] bool contact(const Motion& motion, const Polygon& polygon);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Polygon& polygon);
/// @}

/// @{
/// The same for a triangle, in doubles, without preparation and without memory. Cost: constant.
[[nodiscard]] bool contact(const Motion& motion, const Triangle& triangle);
[[nodiscard]] FirstContact first_contact(const Motion& motion, const Triangle& triangle);
/// @}

}  // namespace touchstone::fast

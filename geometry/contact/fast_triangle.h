// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../shapes/ball.h"
#include "../shapes/triangle.h"

namespace touchstone::fast {

/// Returns whether the ball touches the triangle. Touching counts.
///
/// Correct unless the input lies within rounding error of contact, as all of `fast`. Call it in the default state of
/// the floating-point unit. Sizes from about 1e-50 to 1e50 are safe.
///
/// Guarantees, for every input except as stated
///  (1) scaling ball and triangle by a power of two changes nothing, provided that no intermediate result leaves the
///      normal numbers;
///  (2) growing r never loses a contact;
///  (3) mirroring in a coordinate plane changes nothing;
///  (4) it is right if r differs from the distance by more than `contact_error` of fast_error.h.
///
/// The ball touches the face if the foot is inside and the plane is within reach, an edge if the foot on its line lies
/// on the edge and the line is within reach, or a vertex. All of these are evaluated, without a branch or a division:
/// on distinct queries a mispredicted branch costs more than the products that it saves. This takes about 0.6 of the
/// time of the usual method, the closest point of [ericson2005, 5.1.5]. Needs no preparation. Cost: constant, about 17
/// ns.
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle);

}  // namespace touchstone::fast

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../shapes/ball.h"
#include "../shapes/triangle.h"

namespace touchstone::fast {

/// Does the ball touch the triangle? Touching counts.
///
/// Right wherever the input is farther from contact than rounding reaches, as all of `fast`. Call it in the default
/// state of the floating-point unit; sizes from about 1e-50 to 1e50 are safe.
///
/// Guarantees, for every input but for what is said
///  (1) scaling ball and triangle by a power of two changes nothing, while no intermediate result leaves the normal
///      numbers;
///  (2) growing r never loses a contact;
///  (3) mirroring in a coordinate plane changes nothing.
///
/// A ball touches the face where its foot is inside and the plane near, an edge where its foot on the line is on the
/// edge and the line near, or a vertex. All of it is evaluated, without a branch or a division: on distinct queries a
/// branch foreseen wrongly costs more than the products that it saves, so that this takes about 0.6 of the time of the
/// closest point of [ericson2005, 5.1.5], the usual method. Nothing is prepared. Cost: constant, about 17 ns.
[[nodiscard]] bool contact(const Ball& ball, const Triangle& triangle);

}  // namespace touchstone::fast

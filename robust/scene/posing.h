// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/triangle.h"
#include "../filtered/stage.h"

/// Faces under a pose: every coordinate of R p + t is computed exactly and rounded once, to the nearest double, ties to
/// even. The same bits on every machine, whatever the caller's rounding mode and flush-to-zero setting, which are left
/// as found.
namespace touchstone::scene {

/// Are all its numbers finite?
[[nodiscard]] bool is_finite(const Pose& pose);

/// Infinite where a coordinate rounds beyond the finite doubles; +0 where it rounds to zero. Throws Rejected with
/// `not-finite` for a pose or a point that is not finite, as all of these functions do. Cost: some 50 ns; 3 us a
/// coordinate where double-doubles leave the rounding unsure, which is one in 2^45 of those that are not made to be, or
/// where numbers other than 0 lie beyond 2^-400 to 2^400 in R, 2^-500 to 2^500 in p, 2^1000 in t.
[[nodiscard]] Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point);
/// The same; `counts` is told of every coordinate whether double-doubles or integers of any size rounded it.
[[nodiscard]] Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point, filtered::StageCounts& counts);

/// Throws Rejected for a triangle that `exact::validate` rejects as a polygon, with its code. Cost: about 10 ns.
void expect_valid(const Triangle& triangle);

/// The face of the posed vertices, which `exact::validate` accepts. Throws Rejected where it does not, with its code:
/// rounding may bring vertices together or onto a line, and let loops touch.
[[nodiscard]] Triangle posed(const Pose& pose, const Triangle& triangle);
/// Cost: about 1 us a vertex, most of it for the loops to be looked at again.
[[nodiscard]] Polygon posed(const Pose& pose, const Polygon& polygon);

}  // namespace touchstone::scene

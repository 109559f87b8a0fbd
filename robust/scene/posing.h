// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "../../geometry/shapes/polygon.h"
#include "../../geometry/shapes/pose.h"
#include "../../geometry/shapes/triangle.h"
#include "../filtered/stage.h"

/// Exact contact with many faces under poses.
///
/// Posed vertices: every coordinate of R p + t is computed exactly and rounded once, to the nearest double, ties to
/// even. Its bits depend on neither processor, compiler nor the caller's rounding mode and flush-to-zero setting, which
/// are left as found.
namespace touchstone::scene {

/// Returns whether all numbers of the pose are finite.
[[nodiscard]] bool is_finite(const Pose& pose);

/// Returns R p + t. A coordinate that rounds beyond the finite doubles becomes infinite; one that rounds to zero
/// becomes +0. Throws Rejected with `not-finite` if the pose or the point is not finite, as do all functions here.
///
/// Cost: about 50 ns. A coordinate costs 3 us if double-doubles cannot round it, which happens for one in 2^45 unless
/// the input was made so, or if nonzero numbers lie outside 2^-400 to 2^400 in R, 2^-500 to 2^500 in p, or beyond
/// 2^1000 in t.
[[nodiscard]] Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point);
/// The same; `counts` also receives, for every coordinate, whether double-doubles or integers of any size rounded it.
[[nodiscard]] Eigen::Vector3d posed(const Pose& pose, const Eigen::Vector3d& point, filtered::StageCounts& counts);

/// Throws Rejected, with the code of `exact::validate`, if that rejects the triangle as a polygon, or, where degenerate
/// triangles are segments, if it is not finite. Cost: about 10 ns.
void expect_valid(const Triangle& triangle, Degenerate degenerate = Degenerate::Refuse);

/// Returns the face with its vertices posed. Throws what expect_valid throws about the result: rounding may make
/// vertices equal or collinear. It may also part vertices that were collinear.
[[nodiscard]] Triangle posed(const Pose& pose, const Triangle& triangle, Degenerate degenerate = Degenerate::Refuse);
/// The same. Throws Rejected if exact::validate rejects the result, also where rounding lets loops touch. Cost: about 1
/// us per vertex, most of it to validate the loops again.
[[nodiscard]] Polygon posed(const Pose& pose, const Polygon& polygon);

}  // namespace touchstone::scene

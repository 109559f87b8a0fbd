// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/contact/answer.h"
#include "robust/filtered/detail/ball_triangle_view.h"

/// The point of a triangle closest to a centre, for every finite input, in integers of any size. Requires round to
/// nearest. Cost: about 10 us each.
namespace touchstone::filtered {

/// Returns the feature that contains it.
[[nodiscard]] Feature bigint_nearest(const BallTriangleView& view);
/// Returns a coordinate of the feature's point closest to the centre, or the distance, as the nearest double.
[[nodiscard]] double bigint_point(const BallTriangleView& view, const Feature& feature, int axis);
[[nodiscard]] double bigint_distance(const BallTriangleView& view, const Feature& feature);

}  // namespace touchstone::filtered

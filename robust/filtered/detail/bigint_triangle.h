// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/contact/answer.h"
#include "robust/filtered/detail/ball_triangle_view.h"

/// The last word on the point of a triangle that is closest to a centre, in integers of any size: for every finite
/// input. Requires round to nearest. Cost: some 10 us each.
namespace touchstone::filtered {

/// The feature that holds it.
[[nodiscard]] Feature bigint_nearest(const BallTriangleView& view);
/// A coordinate of the feature's point closest to the centre, and the distance, rounded to the nearest doubles.
[[nodiscard]] double bigint_point(const BallTriangleView& view, const Feature& feature, int axis);
[[nodiscard]] double bigint_distance(const BallTriangleView& view, const Feature& feature);

}  // namespace touchstone::filtered

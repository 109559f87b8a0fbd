// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::scene {

/// Returns the triangle with its vertices posed, as scene::posed does, without looking at the result. Requires finite
/// numbers, and round to nearest without flush-to-zero.
[[nodiscard]] Triangle posed_vertices(const Pose& pose, const Triangle& triangle);

}  // namespace touchstone::scene

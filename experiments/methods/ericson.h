// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::methods {

/// Returns whether ball and triangle touch, by the usual method in plain doubles, the yardstick of `fast`: the distance
/// of the closest point of the triangle, found region by region. Source: [ericson2005, 5.1.5].
[[nodiscard]] bool ericson_contact(const Ball& ball, const Triangle& triangle);
/// Returns the squared distance of that point.
[[nodiscard]] double ericson_squared_distance(const Eigen::Vector3d& center, const Triangle& triangle);

}  // namespace touchstone::methods

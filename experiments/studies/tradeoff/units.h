// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace touchstone::tradeoff {

/// The unit in the last place of a double: from its magnitude to the next larger one; the smallest subnormal for 0.
/// Requires a finite value.
[[nodiscard]] double unit_in_last_place(double value);

/// How far a computed distance is from the exact one, correctly rounded, in units in its last place. Infinite where
/// the computed one is not finite. 0 means correctly rounded, that is at most half a unit from the true distance.
[[nodiscard]] double distance_error(double computed, double exact);

/// The same for points: the largest difference of a coordinate, in units in the last place of the exact point's largest
/// coordinate (those of a coordinate near 0 would measure the choice of the origin).
[[nodiscard]] double point_error(const Eigen::Vector3d& computed, const Eigen::Vector3d& exact);

}  // namespace touchstone::tradeoff

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace touchstone::statistics {

/// Returns the unit in the last place of a double: from its magnitude to the next larger one; the smallest subnormal
/// for 0. Requires a finite value.
[[nodiscard]] double unit_in_last_place(double value);

/// Returns the difference of a computed number from the correctly rounded exact one, in units in the last place of
/// the latter. Infinite if the computed one is not finite. 0 means correctly rounded, that is, at most half a unit from
/// the true number.
[[nodiscard]] double number_error(double computed, double exact);

/// Returns the same for points: the largest difference of a coordinate, in units in the last place of the exact point's
/// largest coordinate (units of a coordinate near 0 would measure the choice of the origin).
[[nodiscard]] double point_error(const Eigen::Vector3d& computed, const Eigen::Vector3d& exact);

}  // namespace touchstone::statistics

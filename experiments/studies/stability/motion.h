// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "experiments/workloads/random.h"

namespace touchstone::stability {

/// The matrix of a rotation by about one degree about a random axis, each entry the double nearest to that of the exact
/// rational matrix. So it is itself not quite a rotation, as every matrix of doubles.
[[nodiscard]] Eigen::Matrix3d small_rotation(workloads::Random& random);

/// The points after `steps` multiplications by the matrix in doubles, one after the other. Cost: about 5 ns a step and
/// point.
[[nodiscard]] std::vector<Eigen::Vector3d> rotated_in_steps(std::vector<Eigen::Vector3d> points,
                                                            const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// The power of the matrix by `steps` multiplications in doubles, one after the other.
[[nodiscard]] Eigen::Matrix3d pose_in_steps(const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// The point under a pose: matrix times point exactly, then each coordinate rounded once to the nearest double.
[[nodiscard]] Eigen::Vector3d posed(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& point);

}  // namespace touchstone::stability

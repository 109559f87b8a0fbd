// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "experiments/cases/workloads/random.h"

namespace touchstone::stability {

/// Draws the matrix of a rotation by about one degree about a random axis. Each entry is the double nearest to that of
/// an exact rational rotation, so, like almost every matrix of doubles, the result is not exactly a rotation.
[[nodiscard]] Eigen::Matrix3d small_rotation(workloads::Random& random);

/// Returns the points after `steps` successive multiplications by the matrix in doubles. Cost: about 5 ns per step and
/// point.
[[nodiscard]] std::vector<Eigen::Vector3d> rotated_in_steps(std::vector<Eigen::Vector3d> points,
                                                            const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// Returns the power of the matrix by `steps` successive multiplications in doubles.
[[nodiscard]] Eigen::Matrix3d pose_in_steps(const Eigen::Matrix3d& matrix, std::uint64_t steps);

/// Returns the point under a pose: matrix times point exactly, then each coordinate rounded once to the nearest double.
[[nodiscard]] Eigen::Vector3d posed(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& point);

}  // namespace touchstone::stability

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/studies/stability/axis.h"
#include "experiments/studies/stability/shapes.h"
#include "geometry/shapes/polygon.h"

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

/// A polygon, and the places of the centres of its balls.
struct Placed {
  Polygon polygon;
  std::vector<BallPlacement> placements;
};

/// A polygon under stress.
struct Scene {
  std::string id;  ///< names axis, level, seed and sample: everything needed to draw it again
  Placed asked;    ///< the input of methods
  std::optional<Placed>
      meant;               ///< for ChainMotion and PoseMotion: the polygon before the motion, placement by placement
  FloatingPointMode mode;  ///< the mode in which methods prepare and answer
  std::vector<std::size_t> critical;  ///< the vertices under stress
};

/// Draws sample `index` of a level of an axis, a function of (axis, level, seed, index) alone; Rounding and Flush have
/// the same scenes at each level. The polygon is accepted by `exact::validate`, and its stress as measured (stress.h)
/// is within a factor of 2 of the level if the level is a ratio, an angle or a distance, and exactly the level if it is
/// a count. Returns nothing if no such polygon was found.
///
/// Polygons that an oblique plane or rounding would break or blur are axis-parallel, or around zero, where doubles are
/// dense; others have any orientation and place. Requires rounding to nearest. Cost: that of exact::validate, plus 5 ns
/// per rotation and vertex.
[[nodiscard]] std::optional<Scene> draw_scene(Axis axis, std::size_t level, std::uint64_t seed, std::uint64_t index);

}  // namespace touchstone::stability

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "experiments/run/timing/measurement.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench_scenes {

/// The costs of poses, repetition by repetition.
struct PoseCosts {
  std::vector<double> nanoseconds;  ///< of Scene::set_pose
  /// The time of queries after it, relative to those of a scene that was built of the posed triangles: whether balls
  /// touch anything, which triangles they touch, and which is nearest.
  std::vector<double> any, all, nearest;
};

/// The goals for objects of every size: nanoseconds, and ratios.
inline constexpr timing::Goal kSetPoseGoal{1000}, kPosedQueryGoal{1.5};

/// Turns and moves an object of these triangles many times, and asks about balls near it. Both scenes take turns, of
/// which the quickest count. Throws std::logic_error if they differ about a ball.
[[nodiscard]] PoseCosts measure_poses(const std::vector<Triangle>& triangles, std::span<const Ball> balls,
                                      unsigned repetitions);

}  // namespace touchstone::bench_scenes

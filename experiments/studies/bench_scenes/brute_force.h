// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

// What checks the exact scene: `exact`, triangle by triangle, and no hierarchy.
namespace touchstone::bench_scenes {

/// The triangles that the ball touches, ascending. All are asked, where there are at most 2,000; else those whose box
/// is not half a radius farther than the ball reaches.
[[nodiscard]] std::vector<std::uint32_t> touched_by_brute_force(std::span<const Triangle> triangles, const Ball& ball);

/// The least distance of a triangle from the point, rounded correctly. Requires a triangle.
[[nodiscard]] double least_distance_by_brute_force(std::span<const Triangle> triangles, const Eigen::Vector3d& center);

/// The distance of one, rounded correctly.
[[nodiscard]] double exact_distance(const Triangle& triangle, const Eigen::Vector3d& center);

}  // namespace touchstone::bench_scenes

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

// What checks the exact scene: `exact`, triangle by triangle, and no hierarchy.
namespace touchstone::bench_scenes {

/// Returns the triangles that the ball touches, ascending. Tests all triangles if there are at most 2,000; otherwise
/// those whose box is less than half a radius beyond the ball's surface.
[[nodiscard]] std::vector<std::uint32_t> touched_by_brute_force(std::span<const Triangle> triangles, const Ball& ball);

/// Returns the time at which the moving ball first touches a triangle, correctly rounded; nothing if it touches none.
/// Asks those triangles whose box is less than half a radius beyond the box that the ball sweeps.
[[nodiscard]] std::optional<double> first_contact_by_brute_force(std::span<const Triangle> triangles,
                                                                 const Motion& motion);

/// Returns the least distance of a triangle from the point, correctly rounded. Requires at least one triangle.
[[nodiscard]] double least_distance_by_brute_force(std::span<const Triangle> triangles, const Eigen::Vector3d& center);

/// Returns the distance of one triangle, correctly rounded.
[[nodiscard]] double exact_distance(const Triangle& triangle, const Eigen::Vector3d& center);

}  // namespace touchstone::bench_scenes

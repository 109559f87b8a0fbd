// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/methods/engines/engines.h"
#include "geometry/bvh/box.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::bench_scenes {

using methods::BuiltScene;
using methods::Library;
using methods::Mesh;

// One a file. Where a library answers by boxes alone, the triangles are asked by `fast::contact`, plain doubles.
[[nodiscard]] Library touchstone_library();
/// The same triangles in a scene of objects of 100 each.
[[nodiscard]] Library touchstone_library_of_objects();
inline constexpr const char* kObjects = "Scene of objects";
[[nodiscard]] Library cgal_aabb_tree_library();
// What textbooks name (broad_phases/): conservative candidates, then `fast::contact`; they do not know `nearest`.
[[nodiscard]] Library grid_library();
[[nodiscard]] Library octree_library();
[[nodiscard]] Library kd_tree_library();
[[nodiscard]] Library sphere_tree_library();
[[nodiscard]] Library kdop_tree_library();

/// Returns the libraries that this program was built with, the exact one first; among them the engines whose adapters
/// are those of the methods.
[[nodiscard]] std::vector<Library> all_libraries();
/// Returns the libraries that it was built without, and the Debian package that each needs.
[[nodiscard]] std::vector<std::string> absent_libraries();

/// Returns which points are inside closed triangles: a ray from a point, along no axis, meets an odd number of them, by
/// CGAL's exact predicates.
[[nodiscard]] std::vector<bool> inside_by_cgal(std::span<const Triangle> triangles,
                                               std::span<const Eigen::Vector3d> points);
/// Returns the function that asks Embree for the hits along a ray to the nearest side of the triangles' box, and says
/// whether their number is odd. Only where the program is built with Embree.
[[nodiscard]] std::function<bool(const Eigen::Vector3d&)> inside_by_embree(const std::vector<Triangle>& triangles,
                                                                           const Box& box);

// What checks the exact scene: `exact`, triangle by triangle, and no hierarchy.

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

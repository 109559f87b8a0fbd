// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

// Contact of one ball and one triangle by others, without the interface of a method: what `fast` and `filtered` are timed
// against.
namespace touchstone::methods {

/// Returns whether ball and triangle touch, by the usual method in plain doubles, the yardstick of `fast`: the distance
/// of the closest point of the triangle, found region by region. Source: [ericson2005, 5.1.5].
[[nodiscard]] bool ericson_contact(const Ball& ball, const Triangle& triangle);
/// Returns the squared distance of that point.
[[nodiscard]] double ericson_squared_distance(const Eigen::Vector3d& center, const Triangle& triangle);

/// By CGAL's kernels. Source: [cgal2022].
namespace cgal {

/// Uses exact predicates: a vertex inside the sphere or do_intersect(sphere, triangle). Not exact for a given radius,
/// because the kernel's sphere stores a rounded r^2, which must be finite.
[[nodiscard]] bool epick_contact(const Ball& ball, const Triangle& triangle);
/// Computes squared_distance(centre, triangle) <= r^2 in exact numbers, converted from the doubles in each call.
[[nodiscard]] bool epeck_contact(const Ball& ball, const Triangle& triangle);

/// @{
/// Uses the kernel's predicate compare_squared_distance(centre, triangle, r^2); over EPICK r^2 is rounded, and must be
/// finite.
[[nodiscard]] bool epick_comparison(const Ball& ball, const Triangle& triangle);
[[nodiscard]] bool epeck_comparison(const Ball& ball, const Triangle& triangle);
/// @}

}  // namespace cgal

}  // namespace touchstone::methods

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/shapes/ball.h"
#include "geometry/shapes/triangle.h"

// What CGAL's kernels cost for one ball and one triangle, without the interface of a method. Source: [cgal2022].
namespace touchstone::methods::cgal {

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

}  // namespace touchstone::methods::cgal

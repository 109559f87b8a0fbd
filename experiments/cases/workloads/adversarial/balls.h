// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::workloads::adversarial {

// Centres and radii near a change of the answer. They are computed in doubles and long doubles and may miss their
// target: `exact` decides the truth about each case.

/// Draws a centre off the face, an edge, or a vertex of the triangle of an edge (the edge and the vertex before it), at
/// a distance of 2^-40 to 2^4 sizes or zero.
[[nodiscard]] Eigen::Vector3d center_off_feature(Random& random, const Polygon& polygon);
/// Draws a centre on an edge, a vertex or the face, up to rounding or some doubles beside it.
[[nodiscard]] Eigen::Vector3d center_on_polygon(Random& random, const Polygon& polygon);
/// Draws a centre straight above a point of an edge or a vertex, up to some doubles.
[[nodiscard]] Eigen::Vector3d center_above_boundary(Random& random, const Polygon& polygon);

/// Draws a ball whose centre has coordinates of magnitude 2^-1074 to 2^-60, or zero; the radius is zero, the exact
/// distance, or one of these coordinates.
[[nodiscard]] Ball ball_close_to_origin(Random& random, const Polygon& polygon);

/// Returns the distance computed in long doubles, moved by -3 to 3 doubles in half of the draws; in one of eight draws
/// the distance to a vertex or the plane, which need not be the nearest feature. Returns a random length if that is not
/// a finite double.
[[nodiscard]] double radius_at_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);
/// The same with the exact distance, at its cost.
[[nodiscard]] double radius_at_exact_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);

/// Returns the largest coordinate difference from vertex 0.
[[nodiscard]] double size_of(const Polygon& polygon);

}  // namespace touchstone::workloads::adversarial

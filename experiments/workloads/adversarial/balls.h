// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "experiments/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::adversarial {

using workloads::Random;

// Centres and radii near where the answer changes. They are drawn in doubles and long doubles and need not be where
// they aim: the truth about a case is asked of `exact`, whatever it came out as.

/// Off the face, an edge or a vertex of an edge's triangle (the edge and the vertex before it), by 2^-40 to 2^4 sizes,
/// or by nothing.
[[nodiscard]] Eigen::Vector3d center_off_feature(Random& random, const Polygon& polygon);
/// On an edge, a vertex or the face, as nearly as doubles have it, or some doubles beside it.
[[nodiscard]] Eigen::Vector3d center_on_polygon(Random& random, const Polygon& polygon);
/// Straight above a point of an edge or a vertex, but for some doubles.
[[nodiscard]] Eigen::Vector3d center_above_boundary(Random& random, const Polygon& polygon);

/// Every coordinate of the centre of a magnitude of 2^-1074 to 2^-60, or zero; radius zero, at the exact distance, or
/// one of these coordinates.
[[nodiscard]] Ball ball_close_to_origin(Random& random, const Polygon& polygon);

/// The distance in long doubles, moved by -3 to 3 doubles in half of the draws; in one of eight the distance to a
/// vertex or the plane, which need not be the nearest feature. Some random length where there is no such double.
[[nodiscard]] double radius_at_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);
/// The same from the exact distance, at its price.
[[nodiscard]] double radius_at_exact_threshold(Random& random, const Eigen::Vector3d& center, const Polygon& polygon);

/// The largest coordinate difference from vertex 0.
[[nodiscard]] double size_of(const Polygon& polygon);

}  // namespace touchstone::adversarial

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "experiments/cases/workloads/lattice.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/polygon.h"

namespace touchstone::workloads {

/// The position of the lattice in space: (x, y) at height h is origin + x u + y v + h w, in doubles.
///
/// u, v and w are orthogonal, right-handed and of equal length `unit`: exactly in an integer frame, where the
/// coordinates of the polygon and of points near it are integers below 2^53, in a planar frame times 2^-51; up to rounding
/// in a rotated frame.
struct Frame {
  Eigen::Vector3d origin, u, v, w;
  double unit;

  [[nodiscard]] Eigen::Vector3d at(double x, double y, double h) const {
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) point[k] = origin[k] + ((x * u[k] + y * v[k]) + h * w[k]);
    return point;
  }
};

/// Draws an integer frame: for a quaternion q of random integers, |q|^2 times its rotation, so that `unit` is the
/// integer |q|^2. A lattice frame has small ones; a planar frame has the
/// largest for which coordinates fit, and all its numbers times 2^-51, so that its polygons are about as large as 1. The origin is an
/// integer point at about `origin_distance` x `size` lattice units x `unit` from zero. Throws std::invalid_argument
/// beyond 2^51.
[[nodiscard]] Frame lattice_frame(Random& random, std::int64_t size, double origin_distance);
[[nodiscard]] Frame planar_frame(Random& random, std::int64_t size, double origin_distance);

/// Draws a rational rotation, evaluated in doubles, with a random scale and a translation by about `origin_distance`
/// times the scaled size.
[[nodiscard]] Frame rotated_frame(Random& random, std::int64_t size, double origin_distance);

/// An outline in space.
struct PlacedOutline {
  Outline outline;
  Frame frame;
  Polygon polygon;
};

/// Places outline `index` of the workload. `exact::validate` accepts the polygon; off_plane is 0 in an integer frame.
/// Throws std::invalid_argument if rounding broke every attempt (origin_distance too large).
[[nodiscard]] PlacedOutline draw_placed_outline(const Workload& workload, std::uint64_t seed, std::uint64_t index);

/// Draws the ball of sample `index` at the place `workload.ball`. The centre does not depend on `workload.doubles`;
/// only the radius of a Near* or LatticeTangent ball does (it stays at least 0).
///
/// Heights above the plane are zero, ample or small: down to 2^-30 of the size of the lattice. `exact::answer` checks
/// Near* balls (nearest feature of that kind, distance > 0) and LatticeTangent balls (touching); those that fail are
/// drawn again. Throws std::invalid_argument if no ball was found, or for a tangent ball in a rotated frame.
[[nodiscard]] Ball draw_ball(const PlacedOutline& placed, const Workload& workload, std::uint64_t seed,
                             std::uint64_t index);

}  // namespace touchstone::workloads

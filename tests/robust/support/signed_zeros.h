// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiments/cases/workloads/random.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/mesh.h"
#include "geometry/shapes/polygon.h"
#include "geometry/shapes/pose.h"
#include "geometry/shapes/triangle.h"

namespace touchstone::contact_tests {

/// @{
/// The same numbers, but every zero has the sign of a random bit: -0 is 0, whatever is asked about it.
void sign_zeros(double& x, workloads::Random& random);
void sign_zeros(Eigen::Vector3d& p, workloads::Random& random);
void sign_zeros(Ball& ball, workloads::Random& random);
void sign_zeros(Triangle& triangle, workloads::Random& random);
void sign_zeros(Polygon& polygon, workloads::Random& random);
void sign_zeros(Pose& pose, workloads::Random& random);
void sign_zeros(Mesh& mesh, workloads::Random& random);
/// @}

/// Which parts of some cases have a -0; a generator that never draws one is blind to a sign that is read wrongly.
struct NegativeZeros {
  bool center = false, radius = false, vertex = false;

  void look_at(const Ball& ball);
  void look_at(const Polygon& polygon);
  void look_at(const Triangle& triangle);
};

}  // namespace touchstone::contact_tests

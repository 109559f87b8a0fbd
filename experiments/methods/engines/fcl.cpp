// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

std::optional<bool> contact(const Ball& ball, const Triangle& t) {
  fcl::Transform3<double> at = fcl::Transform3<double>::Identity();
  at.translation() = ball.center;
  const fcl::Sphere<double> sphere(ball.radius);
  return fcl::detail::GJKSolver_libccd<double>().shapeTriangleIntersect(sphere, at, t.a, t.b, t.c);
}

}  // namespace

void add_fcl(MethodList& list) {
  list.push_back(triangle_method("fcl", "FCL's sphere against triangle, in doubles", contact));
}

}  // namespace touchstone::methods

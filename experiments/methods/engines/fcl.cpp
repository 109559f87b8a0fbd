// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <limits>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

fcl::Transform3<double> at(const Eigen::Vector3d& center) {
  fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();
  transform.translation() = center;
  return transform;
}

std::optional<bool> contact(const Ball& ball, const Triangle& t) {
  const fcl::Sphere<double> sphere(ball.radius);
  return fcl::detail::GJKSolver_libccd<double>().shapeTriangleIntersect(sphere, at(ball.center), t.a, t.b, t.c);
}

/// Conservative advancement with FCL's own settings. It takes meshes, and trees of RSS alone find most contacts on the
/// way; FCL's issues 120 and 555 say why it still misses some. (The solver that FCL takes by default tries ten places.)
std::optional<Sweep> sweep(const Motion& motion, const Triangle& t) {
  fcl::BVHModel<fcl::RSS<double>> mesh;
  mesh.beginModel(1, 3);
  mesh.addTriangle(t.a, t.b, t.c);
  mesh.endModel();
  const fcl::Sphere<double> sphere(motion.ball.radius);
  const fcl::Transform3<double> rest = at(Eigen::Vector3d::Zero());
  fcl::ContinuousCollisionRequest<double> request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResult<double> result;
  fcl::continuousCollide<double>(&sphere, at(motion.ball.center), at(motion.to), &mesh, rest, rest, request, result);
  return Sweep{result.is_collide, result.is_collide ? result.time_of_contact : std::numeric_limits<double>::infinity()};
}

}  // namespace

void add_fcl(MethodList& list) {
  list.push_back(triangle_method("fcl", "FCL's sphere against triangle, in doubles; its conservative advancement",
                                 contact, sweep));
}

}  // namespace touchstone::methods

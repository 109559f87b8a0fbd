// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_LIBCCD
#include <ccd/ccd.h>

#include <array>

#include "experiments/methods/engines/engines.h"

namespace touchstone::methods {
namespace {

void set(ccd_vec3_t* to, const Eigen::Vector3d& v) { ccdVec3Set(to, v.x(), v.y(), v.z()); }

void furthest_of_ball(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Ball& ball = *static_cast<const Ball*>(object);
  const Eigen::Vector3d towards(direction->v[0], direction->v[1], direction->v[2]);
  set(point, ball.center + ball.radius * towards.normalized());
}

void furthest_of_triangle(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Triangle& t = *static_cast<const Triangle*>(object);
  const Eigen::Vector3d towards(direction->v[0], direction->v[1], direction->v[2]);
  const std::array<const Eigen::Vector3d*, 3> vertices{&t.a, &t.b, &t.c};
  const Eigen::Vector3d* furthest = vertices[0];
  for (const Eigen::Vector3d* vertex : vertices)
    if (vertex->dot(towards) > furthest->dot(towards)) furthest = vertex;
  set(point, *furthest);
}

/// Of the capsule that the moving ball covers.
void furthest_of_motion(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Motion& motion = *static_cast<const Motion*>(object);
  const Eigen::Vector3d towards(direction->v[0], direction->v[1], direction->v[2]);
  const Eigen::Vector3d &from = motion.ball.center, &to = motion.to;
  set(point, (to.dot(towards) > from.dot(towards) ? to : from) + motion.ball.radius * towards.normalized());
}

/// The number of iterations is bounded; otherwise some inputs never end.
bool intersects(const void* object, ccd_support_fn furthest, const Triangle& triangle) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = furthest;
  ccd.support2 = furthest_of_triangle;
  ccd.max_iterations = 500;
  return ccdGJKIntersect(object, &triangle, &ccd) != 0;
}

std::optional<bool> contact(const Ball& ball, const Triangle& triangle) {
  return intersects(&ball, furthest_of_ball, triangle);
}

/// libccd has no time.
std::optional<bool> sweep(const Motion& motion, const Triangle& triangle) {
  return intersects(&motion, furthest_of_motion, triangle);
}

}  // namespace

void add_libccd(MethodList& list) {
  list.push_back(
      triangle_method("libccd", "libccd's GJK over support functions, at most 500 iterations", contact, sweep));
}

}  // namespace touchstone::methods
#endif

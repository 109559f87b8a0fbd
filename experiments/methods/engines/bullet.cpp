// SPDX-License-Identifier: GPL-3.0-or-later
#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "this is about Bullet's double build");

btVector3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::optional<bool> contact(const Ball& ball, const Triangle& t) {
  btSphereShape sphere(ball.radius);
  btTriangleShape triangle(vector(t.a), vector(t.b), vector(t.c));
  SphereTriangleDetector detector(&sphere, &triangle, 0);
  btVector3 where, normal;
  btScalar depth = 0, time = 1;
  return detector.collide(vector(ball.center), where, normal, depth, time, 0);
}

}  // namespace

void add_bullet(MethodList& list) {
  list.push_back(triangle_method("bullet", "Bullet's sphere against triangle, its double build", contact));
}

}  // namespace touchstone::methods

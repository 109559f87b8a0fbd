// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

namespace touchstone::methods {

/// Applies Bullet's test of sphere against triangle, in the number type of the included build. `ball`: x, y, z, radius;
/// `triangle`: three vertices.
inline bool bullet_contact(const double ball[4], const double triangle[9]) {
  const auto vector = [](const double* v) {
    return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
  };
  btSphereShape sphere(static_cast<btScalar>(ball[3]));
  btTriangleShape shape(vector(triangle), vector(triangle + 3), vector(triangle + 6));
  SphereTriangleDetector detector(&sphere, &shape, 0);
  btVector3 where, normal;
  btScalar depth = 0, time = 1;
  return detector.collide(vector(ball), where, normal, depth, time, 0);
}

}  // namespace touchstone::methods

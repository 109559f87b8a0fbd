// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <limits>

#include "experiments/methods/engines/bullet_contact.h"

namespace touchstone::methods {

/// Applies Bullet's convex sweep, as btCollisionWorld::convexSweepTest calls it, to a sphere and a triangle without a
/// margin, in the number type of the included build. A sphere that already touches by Bullet's static test touches at
/// time 0, which the sweep alone does not say of one that rests or moves away. `ball`: x, y, z, radius; `to`: the end
/// of its centre; `triangle`: three vertices. Returns the first time, infinite without contact.
inline double bullet_sweep(const double ball[4], const double to[3], const double triangle[9]) {
  if (bullet_contact(ball, triangle)) return 0;
  const auto vector = [](const double* v) {
    return btVector3(static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2]));
  };
  const auto at = [&vector](const double* v) {
    btTransform transform = btTransform::getIdentity();
    transform.setOrigin(vector(v));
    return transform;
  };
  const btSphereShape sphere(static_cast<btScalar>(ball[3]));
  btTriangleShape shape(vector(triangle), vector(triangle + 3), vector(triangle + 6));
  shape.setMargin(0);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision caster(&sphere, &shape, &simplex, &depth);
  btConvexCast::CastResult result;
  result.m_fraction = 1;
  const btTransform rest = btTransform::getIdentity();
  const bool touches = caster.calcTimeOfImpact(at(ball), at(to), rest, rest, result);
  return touches ? static_cast<double>(result.m_fraction) : std::numeric_limits<double>::infinity();
}

}  // namespace touchstone::methods

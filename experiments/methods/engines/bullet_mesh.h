// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <array>
#include <cstdint>
#include <limits>

#include "geometry/shapes/ball.h"
#include "geometry/shapes/motion.h"

namespace touchstone::methods {

inline btVector3 bullet_vector(const Eigen::Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btTransform bullet_place(const Eigen::Vector3d& center) {
  return btTransform(btMatrix3x3::getIdentity(), bullet_vector(center));
}

/// A triangle mesh of Bullet, in the number type of the included build, of `vertices` (three numbers each) and
/// `corners`, which must outlive it. Meshes have no margin, unless their users give them one.
class BulletMesh {
 public:
  BulletMesh(const btScalar* vertices, std::size_t vertex_count, const std::array<std::int32_t, 3>* corners,
             std::size_t count)
      // Bullet only reads what it takes as non-const.
      : arrays_(static_cast<int>(count), const_cast<int*>(corners->data()), static_cast<int>(sizeof *corners),
                static_cast<int>(vertex_count), const_cast<btScalar*>(vertices),
                static_cast<int>(3 * sizeof(btScalar))),
        shape_(&arrays_, count < kMostQuantized) {}

  /// Passes the number of every triangle that the ball touches by Bullet's sphere against triangle. Bullet asks about
  /// the triangles whose boxes the ball's box meets, in a walk that cannot be ended early.
  template <class Visit>
  void each_touched(const Ball& ball, const Visit& visit) const {
    Meeting<Visit> meeting(ball, visit);
    const auto reach = static_cast<btScalar>(ball.radius);
    const btVector3 radius(reach, reach, reach), center = bullet_vector(ball.center);
    shape_.processAllTriangles(&meeting, center - radius, center + radius);
  }

  /// Returns the time that Bullet's convex sweep finds, as btCollisionWorld::convexSweepTest calls it; infinity without
  /// contact.
  [[nodiscard]] double sweep(const Motion& motion) {
    const btSphereShape sphere(static_cast<btScalar>(motion.ball.radius));
    const btTransform from = bullet_place(motion.ball.center), to = bullet_place(motion.to);
    btCollisionObject mesh;
    mesh.setCollisionShape(&shape_);
    btCollisionWorld::ClosestConvexResultCallback first(from.getOrigin(), to.getOrigin());
    btCollisionWorld::objectQuerySingle(&sphere, from, to, &mesh, &shape_, btTransform::getIdentity(), first, 0);
    return first.hasHit() ? static_cast<double>(first.m_closestHitFraction) : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] btBvhTriangleMeshShape& shape() { return shape_; }

 private:
  static constexpr std::size_t kMostQuantized = std::size_t{1} << 21;  // the number that fits into its quantized nodes

  template <class Visit>
  class Meeting : public btTriangleCallback {
   public:
    Meeting(const Ball& ball, const Visit& visit)
        : center_(bullet_vector(ball.center)), sphere_(static_cast<btScalar>(ball.radius)), visit_(visit) {}

    void processTriangle(btVector3* vertices, int, int number) override {
      btTriangleShape triangle(vertices[0], vertices[1], vertices[2]);
      SphereTriangleDetector detector(&sphere_, &triangle, 0);
      btVector3 where, normal;
      btScalar depth = 0, time = 1;
      if (detector.collide(center_, where, normal, depth, time, 0)) visit_(static_cast<std::uint32_t>(number));
    }

   private:
    btVector3 center_;
    btSphereShape sphere_;
    const Visit& visit_;
  };

  btTriangleIndexVertexArray arrays_;
  btBvhTriangleMeshShape shape_;
};

}  // namespace touchstone::methods

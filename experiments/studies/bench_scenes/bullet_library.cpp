// SPDX-License-Identifier: GPL-3.0-or-later
#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <limits>
#include <numeric>
#include <optional>

#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "this is about Bullet's double build");

btVector3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Asks Bullet's sphere against each triangle whose box it meets: a walk that cannot be ended early.
class Meeting : public btTriangleCallback {
 public:
  Meeting(const Ball& ball, std::vector<std::uint32_t>& triangles)
      : center_(vector(ball.center)), sphere_(ball.radius), triangles_(triangles) {}

  void processTriangle(btVector3* vertices, int, int number) override {
    btTriangleShape triangle(vertices[0], vertices[1], vertices[2]);
    SphereTriangleDetector detector(&sphere_, &triangle, 0);
    btVector3 where, normal;
    btScalar depth = 0, time = 1;
    if (detector.collide(center_, where, normal, depth, time, 0))
      triangles_.push_back(static_cast<std::uint32_t>(number));
  }

 private:
  btVector3 center_;
  btSphereShape sphere_;
  std::vector<std::uint32_t>& triangles_;
};

class BulletScene : public BuiltScene {
 public:
  explicit BulletScene(std::span<const Triangle> triangles) : indices_(3 * triangles.size()) {
    std::iota(indices_.begin(), indices_.end(), 0);
    const auto count = static_cast<int>(triangles.size());
    // Bullet only reads what it takes as non-const.
    auto* vertices = const_cast<double*>(triangles.data()->a.data());
    mesh_.emplace(count, indices_.data(), static_cast<int>(3 * sizeof(int)), 3 * count, vertices,
                  static_cast<int>(sizeof(Eigen::Vector3d)));
    constexpr std::size_t kMostQuantized = std::size_t{1} << 21;  // the number that fits into its quantized nodes
    shape_.emplace(&*mesh_, triangles.size() < kMostQuantized);
  }

  bool any(const Ball& ball) override {
    all(ball, found_);
    return !found_.empty();
  }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) override {
    triangles.clear();
    Meeting meeting(ball, triangles);
    const btVector3 radius(ball.radius, ball.radius, ball.radius), center = vector(ball.center);
    shape_->processAllTriangles(&meeting, center - radius, center + radius);
  }

  std::optional<double> first_contact(const Motion& motion) override {
    btSphereShape sphere(motion.ball.radius);
    const btTransform here = btTransform::getIdentity(), from(here.getBasis(), vector(motion.ball.center)),
                      to(here.getBasis(), vector(motion.to));
    btCollisionObject mesh;
    mesh.setCollisionShape(&*shape_);
    btCollisionWorld::ClosestConvexResultCallback first(from.getOrigin(), to.getOrigin());
    btCollisionWorld::objectQuerySingle(&sphere, from, to, &mesh, &*shape_, here, first, 0);
    return first.hasHit() ? std::optional<double>(first.m_closestHitFraction) : std::nullopt;
  }

 private:
  std::vector<int> indices_;
  std::optional<btTriangleIndexVertexArray> mesh_;
  std::optional<btBvhTriangleMeshShape> shape_;
  std::vector<std::uint32_t> found_;
};

}  // namespace

Library bullet_library() {
  return {.name = "Bullet",
          .build = [](std::span<const Triangle> triangles) { return std::make_unique<BulletScene>(triangles); },
          .knows_nearest = false,
          .knows_motions = true};
}

}  // namespace touchstone::bench_scenes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_BULLET
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <cmath>

#include "experiments/methods/engines/bullet_mesh.h"
#include "experiments/methods/engines/engines.h"

namespace touchstone::methods {
namespace {

static_assert(sizeof(btScalar) == sizeof(double), "this is about Bullet's double build");

/// It reads the mesh's own vertices.
BulletMesh bullet_mesh(const Mesh& mesh) {
  return {mesh.vertices.front().data(), mesh.vertices.size(), mesh.corners.data(), mesh.corners.size()};
}

class BulletScene : public BuiltScene {
 public:
  explicit BulletScene(const Mesh& mesh) : mesh_(bullet_mesh(mesh)) {}

  [[nodiscard]] bool any(const Ball& ball) const override {
    bool found = false;
    mesh_.each_touched(ball, [&](std::uint32_t) { found = true; });
    return found;
  }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    mesh_.each_touched(ball, [&](std::uint32_t number) { triangles.push_back(number); });
  }

  [[nodiscard]] std::optional<double> first_contact(const Motion& motion) const override {
    const double time = mesh_.sweep(motion);
    return std::isfinite(time) ? std::optional(time) : std::nullopt;
  }

 private:
  mutable BulletMesh mesh_;  // Bullet only reads what it takes as non-const
};

/// What a world asks with, of one thread.
struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};
};

/// Asks as a world of Bullet does, with nothing set: of the triangles whose boxes the ball's box meets, it reports
/// points of contact within its contact breaking threshold, 0.02 times half the diagonal of the smaller shape's box.
/// For a ball that is 0.035 times its radius.
class BulletPair : public BuiltScene {
 public:
  explicit BulletPair(const Mesh& mesh) : mesh_(bullet_mesh(mesh)) {}

  [[nodiscard]] bool any(const Ball& ball) const override {
    thread_local World world;
    btSphereShape sphere(ball.radius);
    btCollisionObject moving, standing;
    moving.setCollisionShape(&sphere);
    moving.setWorldTransform(bullet_place(ball.center));
    standing.setCollisionShape(&mesh_.shape());
    Reported reported;
    world.world.contactPairTest(&moving, &standing, reported);
    return reported.any;
  }

 private:
  struct Reported : btCollisionWorld::ContactResultCallback {
    btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      any = true;
      return 0;
    }
    bool any = false;
  };

  mutable BulletMesh mesh_;  // likewise
};

}  // namespace

Library bullet_library() {
  return {.name = "Bullet",
          .build = [](const Mesh& mesh) { return std::make_unique<BulletScene>(mesh); },
          .knows_nearest = false,
          .knows_motions = true};
}

void add_bullet(MethodList& list) {
  list.push_back(mesh_method("bullet", "Bullet's sphere against the triangles of a mesh, in doubles; its convex sweep",
                             bullet_library()));
  list.push_back(mesh_method("bullet-defaults", "Bullet's contactPairTest with its own threshold, in doubles",
                             {.name = "Bullet, its threshold",
                              .build = [](const Mesh& mesh) { return std::make_unique<BulletPair>(mesh); },
                              .knows_all = false,
                              .knows_nearest = false}));
}

}  // namespace touchstone::methods
#endif

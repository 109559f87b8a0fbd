// SPDX-License-Identifier: GPL-3.0-or-later
// Steps a pile of balls on a triangle mesh with Bullet, in the number type of the included build, and prints every
// question of sphere and triangle that its narrow phase asks.
//
// Standard input, numbers between white space: the vertices, their count first, the triangles likewise, as three
// indices, the balls as centre and radius, the steps. Standard output, a line for each question: the triangle, Bullet's
// place of the centre, the radius, the radius with the contact breaking threshold that Bullet adds, each as a
// hexadecimal double; whether it found the triangle within that, and whether at a depth of at least 0.
#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionDispatch/btSphereTriangleCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

namespace {

/// Bullet's algorithm, after the question was printed with the answer of the same detector.
class Recorder : public btSphereTriangleCollisionAlgorithm {
 public:
  Recorder(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
           const btCollisionObjectWrapper* b, bool swapped)
      : btSphereTriangleCollisionAlgorithm(info.m_manifold, info, a, b, swapped),
        manifold_(info.m_manifold),
        swapped_(swapped) {}

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& dispatch, btManifoldResult* result) override {
    const btCollisionObjectWrapper *ball = swapped_ ? b : a, *face = swapped_ ? a : b;
    auto* sphere = static_cast<btSphereShape*>(const_cast<btCollisionShape*>(ball->getCollisionShape()));
    auto* triangle = static_cast<btTriangleShape*>(const_cast<btCollisionShape*>(face->getCollisionShape()));
    const btScalar threshold = manifold_->getContactBreakingThreshold() + result->m_closestPointDistanceThreshold;
    const btVector3 center = face->getWorldTransform().inverseTimes(ball->getWorldTransform()).getOrigin();
    SphereTriangleDetector detector(sphere, triangle, threshold);
    btVector3 point, normal;
    btScalar depth = 0, time = 1;
    const bool within = detector.collide(center, point, normal, depth, time, threshold);
    std::printf("%d %a %a %a %a %a %d %d\n", face->m_index, static_cast<double>(center.x()),
                static_cast<double>(center.y()), static_cast<double>(center.z()),
                static_cast<double>(sphere->getRadius()), static_cast<double>(sphere->getRadius() + threshold),
                within ? 1 : 0, within && depth <= 0 ? 1 : 0);
    btSphereTriangleCollisionAlgorithm::processCollision(a, b, dispatch, result);
  }

 private:
  btPersistentManifold* manifold_;
  bool swapped_;
};

struct CreateRecorder : btCollisionAlgorithmCreateFunc {
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* a,
                                                 const btCollisionObjectWrapper* b) override {
    return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Recorder))) Recorder(info, a, b, m_swapped);
  }
};

/// Bullet's own algorithms, with the recorder in place of that for a sphere and a triangle.
class Configuration : public btDefaultCollisionConfiguration {
 public:
  Configuration() { swapped_.m_swapped = true; }
  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int a, int b) override {
    if (a == SPHERE_SHAPE_PROXYTYPE && b == TRIANGLE_SHAPE_PROXYTYPE) return &recorder_;
    if (a == TRIANGLE_SHAPE_PROXYTYPE && b == SPHERE_SHAPE_PROXYTYPE) return &swapped_;
    return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(a, b);
  }
  btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int a, int b) override {
    return getCollisionAlgorithmCreateFunc(a, b);
  }

 private:
  CreateRecorder recorder_, swapped_;
};

template <class T>
T next() {
  T value{};
  if (!(std::cin >> value)) throw std::runtime_error("a number is missing");
  return value;
}

btVector3 next_point() {
  btScalar coordinates[3];
  for (btScalar& x : coordinates) x = static_cast<btScalar>(next<double>());
  return {coordinates[0], coordinates[1], coordinates[2]};
}

void run() {
  std::vector<btVector3> vertices(next<std::size_t>());
  for (btVector3& vertex : vertices) vertex = next_point();
  btTriangleMesh mesh;
  for (auto left = next<std::size_t>(); left > 0; --left) {
    const auto a = next<std::size_t>(), b = next<std::size_t>(), c = next<std::size_t>();
    mesh.addTriangle(vertices.at(a), vertices.at(b), vertices.at(c));
  }
  btBvhTriangleMeshShape ground(&mesh, false);

  Configuration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
  world.setGravity({0, 0, btScalar(-9.81)});

  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<std::unique_ptr<btSphereShape>> shapes;
  bodies.push_back(std::make_unique<btRigidBody>(0, nullptr, &ground));
  world.addRigidBody(bodies.back().get());
  for (auto left = next<std::size_t>(); left > 0; --left) {
    const btVector3 center = next_point();
    shapes.push_back(std::make_unique<btSphereShape>(static_cast<btScalar>(next<double>())));
    btVector3 inertia;
    shapes.back()->calculateLocalInertia(1, inertia);
    bodies.push_back(std::make_unique<btRigidBody>(1, nullptr, shapes.back().get(), inertia));
    bodies.back()->setWorldTransform(btTransform(btQuaternion::getIdentity(), center));
    world.addRigidBody(bodies.back().get());
  }
  for (auto left = next<std::size_t>(); left > 0; --left) world.stepSimulation(btScalar(1) / 60, 0);
  for (const auto& body : bodies) world.removeRigidBody(body.get());
}

}  // namespace

int main() {
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}

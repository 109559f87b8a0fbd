// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_ODE
#include <ode/ode.h>

#include <mutex>

#include "experiments/methods/engines/engines.h"

namespace touchstone::methods {
namespace {

/// ODE's collider has one global state, so calls are serialised.
std::mutex& turn() {
  static std::mutex mutex;
  return mutex;
}

void begin() {
  static const bool begun = dInitODE2(0) != 0;
  (void)begun;
  thread_local const bool here = dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll)) != 0;
  (void)here;
}

/// ODE sees a triangle from the front alone, so it gets each one both ways round, as a user gives a surface that has
/// two sides.
class OdeScene : public BuiltScene {
 public:
  explicit OdeScene(const Mesh& mesh) {
    const std::lock_guard lock(turn());
    begin();
    for (const Eigen::Vector3d& v : mesh.vertices) vertices_.insert(vertices_.end(), {v.x(), v.y(), v.z()});
    for (const auto& [a, b, c] : mesh.corners)
      for (const std::int32_t corner : {a, b, c, a, c, b}) indices_.push_back(static_cast<dTriIndex>(corner));
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double), static_cast<int>(vertices_.size() / 3),
                                indices_.data(), static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
    mesh_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  ~OdeScene() override {
    const std::lock_guard lock(turn());
    dGeomDestroy(mesh_);
    dGeomTriMeshDataDestroy(data_);
  }

  [[nodiscard]] bool any(const Ball& ball) const override {
    if (ball.radius == 0) return false;  // ODE has no sphere of radius 0
    const std::lock_guard lock(turn());
    begin();
    const dGeomID sphere = dCreateSphere(nullptr, ball.radius);
    dGeomSetPosition(sphere, ball.center.x(), ball.center.y(), ball.center.z());
    dContactGeom contact;
    const int contacts = dCollide(sphere, mesh_, 1, &contact, sizeof contact);
    dGeomDestroy(sphere);
    return contacts > 0;
  }

 private:
  std::vector<double> vertices_;
  std::vector<dTriIndex> indices_;
  dTriMeshDataID data_;
  dGeomID mesh_;
};

}  // namespace

void add_ode(MethodList& list) {
  list.push_back(
      mesh_method("ode", "ODE's sphere against a mesh, each triangle given both ways round",
                  {.name = "ODE", .build = [](const Mesh& mesh) { return std::make_unique<OdeScene>(mesh); }}));
}

}  // namespace touchstone::methods
#endif

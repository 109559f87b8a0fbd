// SPDX-License-Identifier: GPL-3.0-or-later
#include <ode/ode.h>

#include <array>
#include <mutex>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

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

class OdeMesh : public TriangleSet {
 public:
  explicit OdeMesh(std::vector<Triangle> triangles) {
    const std::lock_guard lock(turn());
    begin();
    for (const Triangle& t : triangles)
      for (const Eigen::Vector3d& v : {t.a, t.b, t.c}) {
        indices_.push_back(static_cast<dTriIndex>(vertices_.size() / 3));
        vertices_.insert(vertices_.end(), {v.x(), v.y(), v.z()});
      }
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double), static_cast<int>(vertices_.size() / 3),
                                indices_.data(), static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
    mesh_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;
  ~OdeMesh() override {
    const std::lock_guard lock(turn());
    dGeomDestroy(mesh_);
    dGeomTriMeshDataDestroy(data_);
  }

  [[nodiscard]] std::optional<bool> contact(const Ball& ball) const override {
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
  list.push_back(triangle_set_method(
      "ode", "ODE's sphere against a mesh, which it sees from the front alone", [](std::vector<Triangle> triangles) {
        return std::unique_ptr<TriangleSet>(std::make_unique<OdeMesh>(std::move(triangles)));
      }));
}

}  // namespace touchstone::methods

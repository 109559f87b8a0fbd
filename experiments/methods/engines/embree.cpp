// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_EMBREE
#include <rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/triangle_contacts.h"
#include "geometry/contact/fast_triangle.h"

namespace touchstone::methods {
namespace {

/// Embree finds the triangles whose boxes meet a sphere; it has no closest point of a triangle, and leaves the decision
/// to its users. It knows floats only: triangles and centres are rounded, so that its spheres must reach farther by
/// what that moves them. A triangle that a ball may touch is asked in doubles.
class EmbreeScene : public BuiltScene {
 public:
  explicit EmbreeScene(const Mesh& mesh) : triangles_(mesh.triangles) {
    if (device_ == nullptr) throw std::runtime_error("Embree: no device");
    rtcSetDeviceMemoryMonitorFunction(device_, &EmbreeScene::count_memory, this);
    scene_ = rtcNewScene(device_);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    fill(geometry, mesh);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree: no scene of these triangles");
  }
  ~EmbreeScene() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  [[nodiscard]] bool any(const Ball& ball) const override {
    Search search{*this, ball, nullptr, false, 0, 0};
    run(search, &EmbreeScene::meet_for_any, reach(ball.radius, ball.center));
    return search.found;
  }

  void all(const Ball& ball, std::vector<std::uint32_t>& triangles) const override {
    triangles.clear();
    Search search{*this, ball, &triangles, false, 0, 0};
    run(search, &EmbreeScene::meet_for_all, reach(ball.radius, ball.center));
  }

  [[nodiscard]] std::uint32_t nearest(const Eigen::Vector3d& center) const override {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Search search{*this, {center, 0}, nullptr, false, 0, kInfinity};
    run(search, &EmbreeScene::meet_for_nearest, std::numeric_limits<float>::infinity());
    return search.nearest;
  }

  /// It has nodes that it did not get from malloc.
  [[nodiscard]] std::optional<std::size_t> bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

 private:
  struct Search {
    const EmbreeScene& scene;
    Ball ball;
    std::vector<std::uint32_t>* triangles;
    bool found;
    std::uint32_t nearest;
    double squared_distance;
  };

  static bool count_memory(void* self, ssize_t bytes, bool) {
    static_cast<EmbreeScene*>(self)->bytes_ += bytes;
    return true;
  }

  /// The numbers of vertices are the mesh's own; only the vertices are copied, as floats.
  void fill(RTCGeometry geometry, const Mesh& mesh) {
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices.size()));
    for (const Eigen::Vector3d& point : mesh.vertices) {
      for (const double x : point) *vertex++ = static_cast<float>(x);
      largest_ = std::max(largest_, point.lpNorm<Eigen::Infinity>());
    }
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.corners.data(), 0,
                               sizeof mesh.corners.front(), mesh.corners.size());
  }

  /// At least: the radius, what rounding moves, and what computing in floats may lose.
  [[nodiscard]] float reach(double radius, const Eigen::Vector3d& center) const {
    const double moved = 0x1p-22 * std::max(largest_, center.lpNorm<Eigen::Infinity>());
    return static_cast<float>((radius + moved) * (1 + 0x1p-20));
  }

  void run(Search& search, RTCPointQueryFunction meet, float radius) const {
    const Eigen::Vector3f center = search.ball.center.cast<float>();
    RTCPointQuery query{center.x(), center.y(), center.z(), 0, radius};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, meet, &search);
  }

  static bool meet_for_any(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    if (search.found || !fast::contact(search.ball, search.scene.triangles_[arguments->primID])) return false;
    search.found = true;
    arguments->query->radius = 0;
    return true;
  }

  static bool meet_for_all(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    if (fast::contact(search.ball, search.scene.triangles_[arguments->primID]))
      search.triangles->push_back(arguments->primID);
    return false;
  }

  static bool meet_for_nearest(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<Search*>(arguments->userPtr);
    const double squared = ericson_squared_distance(search.ball.center, search.scene.triangles_[arguments->primID]);
    if (!(squared < search.squared_distance)) return false;
    search.squared_distance = squared;
    search.nearest = arguments->primID;
    arguments->query->radius = search.scene.reach(std::sqrt(squared), search.ball.center);
    return true;
  }

  std::span<const Triangle> triangles_;
  std::atomic<std::ptrdiff_t> bytes_{0};
  double largest_ = 0;
  RTCDevice device_ = rtcNewDevice(nullptr);  // a number of threads would hold for the whole program
  RTCScene scene_ = nullptr;
};

}  // namespace

Library embree_library() {
  return {.name = kEmbree, .build = [](const Mesh& mesh) { return std::make_unique<EmbreeScene>(mesh); }};
}

void add_embree(MethodList& list) {
  list.push_back(mesh_method(
      "embree-fast", "Embree's point query in floats, then fast about the triangles that it finds", embree_library()));
}

}  // namespace touchstone::methods
#endif

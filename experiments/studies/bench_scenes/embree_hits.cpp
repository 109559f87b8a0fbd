// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program/built_with.h"

#if TOUCHSTONE_HAS_EMBREE
#include <rtcore.h>

#include <limits>
#include <memory>
#include <stdexcept>

#include "experiments/studies/bench_scenes/library.h"

namespace touchstone::bench_scenes {
namespace {

/// Counts the triangles along a ray, in floats, each of which Embree offers to a filter that accepts none.
class Hits {
 public:
  Hits(const std::vector<Triangle>& triangles, const Box& box) : box_(box) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const methods::Mesh mesh(triangles);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices.size()));
    for (const Eigen::Vector3d& point : mesh.vertices)
      for (const double x : point) *vertex++ = static_cast<float>(x);
    auto* corner = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof mesh.corners.front(), mesh.corners.size()));
    for (const auto& corners : mesh.corners)
      for (const std::int32_t number : corners) *corner++ = static_cast<std::uint32_t>(number);
    rtcSetGeometryOccludedFilterFunction(geometry, &Hits::count);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree: no scene of these triangles");
  }
  Hits(const Hits&) = delete;
  Hits& operator=(const Hits&) = delete;
  ~Hits() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  /// Returns how many triangles the ray to the nearest side of the box meets: the ray that Solid takes.
  [[nodiscard]] std::uint64_t along_ray(const Eigen::Vector3d& point) const {
    RTCRay ray{};
    ray.org_x = static_cast<float>(point.x());
    ray.org_y = static_cast<float>(point.y());
    ray.org_z = static_cast<float>(point.z());
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = std::numeric_limits<unsigned>::max();
    float* const direction[] = {&ray.dir_x, &ray.dir_y, &ray.dir_z};
    double shortest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      for (const bool up : {false, true}) {
        const double way = up ? box_.high[axis] - point[axis] : point[axis] - box_.low[axis];
        if (!(way < shortest)) continue;
        shortest = way;
        for (float* part : direction) *part = 0;
        *direction[axis] = up ? 1 : -1;
      }
    Context context{};
#if RTC_VERSION_MAJOR == 3
    rtcInitIntersectContext(&context.embree);
    rtcOccluded1(scene_, &context.embree, &ray);
#else
    rtcInitRayQueryContext(&context.embree);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context.embree;
    rtcOccluded1(scene_, &ray, &arguments);
#endif
    return context.hits;
  }

 private:
#if RTC_VERSION_MAJOR == 3
  using EmbreeContext = RTCIntersectContext;
#else
  using EmbreeContext = RTCRayQueryContext;
#endif
  struct Context {
    EmbreeContext embree;  // first: Embree passes a pointer to it
    std::uint64_t hits;
  };

  static void count(const RTCFilterFunctionNArguments* arguments) {
    ++reinterpret_cast<Context*>(arguments->context)->hits;
    arguments->valid[0] = 0;
  }

  Box box_;
  RTCDevice device_ = rtcNewDevice(nullptr);  // a number of threads would hold for the whole program
  RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace

std::function<bool(const Eigen::Vector3d&)> inside_by_embree(const std::vector<Triangle>& triangles, const Box& box) {
  const auto hits = std::make_shared<const Hits>(triangles, box);
  return [hits](const Eigen::Vector3d& point) { return hits->along_ray(point) % 2 == 1; };
}

}  // namespace touchstone::bench_scenes
#endif

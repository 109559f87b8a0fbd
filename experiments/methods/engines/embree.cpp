// SPDX-License-Identifier: GPL-3.0-or-later
#include <embree3/rtcore.h>

#include <memory>
#include <stdexcept>

#include "experiments/methods/engines/engines.h"
#include "experiments/methods/engines/triangle_method.h"

namespace touchstone::methods {
namespace {

using Point = Eigen::Vector3f;

RTCDevice device() {
  static const RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  if (device == nullptr) throw std::runtime_error("Embree: no device");
  return device;
}

/// Returns the closest point of a triangle, in floats, region by region [ericson2005, 5.1.5].
Point closest_point(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const float d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Point bp = p - b;
  const float d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Point cp = p - c;
  const float d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  const float scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

/// Embree finds the triangles whose boxes intersect a float sphere; the closest point, which Embree leaves to its
/// users, decides.
class EmbreeMesh : public TriangleSet {
 public:
  explicit EmbreeMesh(const std::vector<Triangle>& triangles)
      : scene_(rtcNewScene(device()), rtcReleaseScene),
        geometry_(rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE)) {
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
    unsigned next = 0;
    for (const Triangle& t : triangles)
      for (const Eigen::Vector3d& v : {t.a, t.b, t.c}) {
        points_.emplace_back(v.cast<float>());
        for (const float x : points_.back()) *vertices++ = x;
        *indices++ = next++;
      }
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_.get(), geometry_);
    rtcReleaseGeometry(geometry_);
    rtcCommitScene(scene_.get());
  }

  [[nodiscard]] std::optional<bool> contact(const Ball& ball) const override {
    const Point center = ball.center.cast<float>();
    Asked asked{this, center, static_cast<float>(ball.radius), false};
    RTCPointQuery query{center.x(), center.y(), center.z(), 0, asked.radius};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &query, &context, &EmbreeMesh::look, &asked);
    return asked.hit;
  }

 private:
  struct Asked {
    const EmbreeMesh* mesh;
    Point center;
    float radius;
    bool hit;
  };

  static bool look(RTCPointQueryFunctionArguments* arguments) {
    auto& asked = *static_cast<Asked*>(arguments->userPtr);
    const Point* corner = &asked.mesh->points_[3 * arguments->primID];
    const Point closest = closest_point(asked.center, corner[0], corner[1], corner[2]);
    if ((closest - asked.center).squaredNorm() <= asked.radius * asked.radius) asked.hit = true;
    return false;
  }

  std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene_;
  RTCGeometry geometry_;
  std::vector<Point> points_;
};

}  // namespace

void add_embree(MethodList& list) {
  list.push_back(triangle_set_method("embree", "Embree's point query, and the closest point of a triangle in floats",
                                     [](std::vector<Triangle> triangles) {
                                       return std::unique_ptr<TriangleSet>(std::make_unique<EmbreeMesh>(triangles));
                                     }));
}

}  // namespace touchstone::methods

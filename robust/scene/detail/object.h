// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "geometry/contact/answer.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {
namespace detail {

/// Returns make(). If that throws FaceRejected, throws Rejected for the face of the object; its set starts at face
/// `first`.
template <class Make>
auto made(const std::string& object, std::size_t first, const Make& make) {
  try {
    return make();
  } catch (const FaceRejected& rejected) {
    const auto& [code, message] = rejected.rejection;
    throw Rejected(
        {code, "object \"" + object + "\", face " + std::to_string(first + rejected.number) + ": " + message});
  }
}

}  // namespace detail

/// An object of a scene.
struct Scene::Object {
  Object(std::string name_, Faces faces)
      : name(std::move(name_)),
        triangles(detail::made(name, 0, [&] { return detail::TriangleSet(faces.triangles, faces.degenerate); })),
        polygons(detail::made(name, triangle_count(), [&] { return detail::PolygonSet(std::move(faces.polygons)); })) {}
  Object(const Object& other, const Pose& pose_)
      : name(other.name),
        pose(pose_),
        triangles(detail::made(name, 0, [&] { return detail::TriangleSet(other.triangles, pose); })),
        polygons(detail::made(name, triangle_count(), [&] { return detail::PolygonSet(other.polygons, pose); })) {}

  [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles.size()); }

  static FaceId first_triangle(std::uint32_t number) { return {number, 0}; }
  [[nodiscard]] bool has_triangles() const { return triangles.size() > 0; }
  [[nodiscard]] bool has_polygons() const { return !polygons.polygons.empty(); }
  [[nodiscard]] FaceId first_polygon(std::uint32_t number) const { return {number, triangle_count()}; }

  std::string name;
  Pose pose;
  detail::TriangleSet triangles;
  detail::PolygonSet polygons;
};

template <class F>
bool Scene::any_of(const Objects& objects, const F& f) const {
  if (objects.some_) {
    for (const std::uint32_t number : *objects.some_)
      if (f(number, *objects_[number])) return true;
    return false;
  }
  for (std::uint32_t number = 0; number < objects_.size(); ++number)
    if (f(number, *objects_[number])) return true;
  return false;
}

}  // namespace touchstone::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "geometry/contact/answer.h"
#include "robust/scene/detail/face_sets.h"
#include "robust/scene/detail/object_boxes.h"
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
        polygons(detail::made(name, triangle_count(), [&] { return detail::PolygonSet(std::move(faces.polygons)); })),
        box(triangles.box().joined(polygons.box)) {}
  Object(const Object& other, const Pose& pose_)
      : name(other.name),
        pose(pose_),
        triangles(detail::made(name, 0, [&] { return detail::TriangleSet(other.triangles, pose); })),
        polygons(detail::made(name, triangle_count(), [&] { return detail::PolygonSet(other.polygons, pose); })),
        box(triangles.box().joined(polygons.box)) {}

  [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles.size()); }

  [[nodiscard]] std::size_t face_count() const { return triangles.size() + polygons.polygons.size(); }

  static FaceId first_triangle(std::uint32_t number) { return {number, 0}; }
  [[nodiscard]] bool has_triangles() const { return triangles.size() > 0; }
  [[nodiscard]] bool has_polygons() const { return !polygons.polygons.empty(); }
  [[nodiscard]] FaceId first_polygon(std::uint32_t number) const { return {number, triangle_count()}; }

  std::string name;
  Pose pose;
  detail::TriangleSet triangles;
  detail::PolygonSet polygons;
  Box box;  ///< of all faces
};

/// The objects of a scene by name and by place.
struct Scene::Index {
  std::map<std::string, std::uint32_t, std::less<>> numbers;
  detail::ObjectBoxes boxes;
};

template <class F>
bool Scene::any_of(const Objects& objects, const F& f) const {
  const auto ask = [&](std::uint32_t number) { return objects_[number] != nullptr && f(number, *objects_[number]); };
  if (objects.some_) return std::ranges::any_of(*objects.some_, ask);
  for (std::uint32_t number = 0; number < objects_.size(); ++number)
    if (ask(number)) return true;
  return false;
}

inline std::size_t Scene::count_of(const Objects& objects) const {
  return objects.some_ ? objects.some_->size() : index_->numbers.size();
}
// A small share of all is asked one by one, too: the boxes of the others would be in the way.
inline bool Scene::by_boxes(const Objects& objects) const {
  constexpr std::size_t kFewest = 16, kShare = 8;
  const std::size_t count = count_of(objects);
  return count >= kFewest && count >= index_->numbers.size() / kShare;
}

template <class F>
bool Scene::any_near(const Ball& ball, const Objects& objects, const F& f) const {
  if (!by_boxes(objects)) return any_of(objects, f);
  return std::ranges::any_of(index_->boxes.in_reach(detail::BoxesInReach(ball)),
                             [&](std::uint32_t number) { return objects.has(number) && f(number, *objects_[number]); });
}
template <class F>
bool Scene::any_near(const Motion& motion, const Objects& objects, const F& f) const {
  if (!by_boxes(objects)) return any_of(objects, f);
  return std::ranges::any_of(index_->boxes.on_way(motion), [&](const detail::ObjectBoxes::OnWay& box) {
    return objects.has(box.number) && f(box.number, *objects_[box.number]);
  });
}

}  // namespace touchstone::scene

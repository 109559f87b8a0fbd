// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/scene.h"

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bindings/c/calls.h"
#include "bindings/c/shapes.h"
#include "geometry/shapes/pose.h"

using namespace touchstone;
using namespace touchstone::c;
using scene::Scene;

struct touchstone_scene {
  Scene held;
};

struct touchstone_face_lists {
  std::vector<uint64_t> offsets{0};
  std::vector<touchstone_face_id> faces;
};

namespace {

Degenerate degenerate_of(const touchstone_faces& faces) {
  switch (faces.degenerate) {
    case TOUCHSTONE_REFUSE_DEGENERATE: return Degenerate::Refuse;
    case TOUCHSTONE_DEGENERATE_AS_SEGMENTS: return Degenerate::AsSegments;
    default:
      throw std::invalid_argument("no way to take degenerate triangles has the number " +
                                  std::to_string(faces.degenerate));
  }
}

scene::Faces faces_of(const touchstone_faces& faces) {
  scene::Faces result{triangles_of(faces.triangles), {}, degenerate_of(faces)};
  for (const touchstone_polygon* polygon : given(faces.polygons, faces.polygon_count, "the array of polygons"))
    result.polygons.push_back(given(polygon, "a polygon of the array").shape);
  return result;
}

Pose pose_of(const touchstone_pose& pose) {
  Pose result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) result.rotation(row, column) = pose.rotation[row][column];
    result.translation[row] = pose.translation[row];
  }
  return result;
}

touchstone_nearest_face converted(const std::optional<scene::NearestFace>& nearest) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!nearest) return {{TOUCHSTONE_NONE, TOUCHSTONE_NONE}, {}, {}, kInfinity, {}, -kInfinity};
  const auto& [face, feature, p, distance, n, depth] = *nearest;
  return {{face.object, face.face}, in_c(feature), {p[0], p[1], p[2]}, distance, {n[0], n[1], n[2]}, depth};
}

touchstone_first_face converted(const std::optional<scene::FirstFace>& first) {
  if (!first) return {{TOUCHSTONE_NONE, TOUCHSTONE_NONE}, in_c(FirstContact{})};
  return {{first->face.object, first->face.face}, in_c(first->contact)};
}

/// Calls ask(scene, objects), about `count` items, as the options say.
template <class Ask>
void ask_scene(const touchstone_scene* scene, const touchstone_scene_options* options, std::size_t count,
               const Ask& ask) {
  const Scene& held = given(scene, "the scene").held;
  if (options == nullptr) return ask(held, Scene::Objects());
  const auto numbers = given(options->objects, options->object_count, "the array of objects");
  const auto objects = options->objects == nullptr
                           ? Scene::Objects()
                           : Scene::Objects(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
  on_threads(options->threads, count, [&] { ask(held, objects); });
}

/// Returns what ask(items) returns. One item is asked alone, as a batch costs more.
template <class Item, class Ask>
auto each_of(std::span<const Item> items, const Ask& ask) {
  using All = decltype(ask(items));
  return items.size() == 1 ? All(1, ask(items[0])) : ask(items);
}

}  // namespace

touchstone_status touchstone_scene_create(touchstone_scene** scene, touchstone_error* error) {
  return created(scene, error, [] { return std::make_unique<touchstone_scene>(); });
}

void touchstone_scene_free(touchstone_scene* scene) { delete scene; }

touchstone_status touchstone_scene_add(touchstone_scene* scene, const char* name, const touchstone_faces* faces,
                                       const touchstone_pose* pose, uint32_t* object, touchstone_error* error) {
  return guarded(error, [&] {
    auto& held = given(scene, "the scene").held;
    uint32_t& number = given(object, "the pointer to the object");
    number = held.add(&given(name, "the name"), faces_of(given(faces, "the faces")),
                      pose == nullptr ? Pose{} : pose_of(*pose));
  });
}

touchstone_status touchstone_scene_remove(touchstone_scene* scene, uint32_t object, touchstone_error* error) {
  return guarded(error, [&] { given(scene, "the scene").held.remove(object); });
}

touchstone_status touchstone_scene_set_pose(touchstone_scene* scene, uint32_t object, const touchstone_pose* pose,
                                            touchstone_error* error) {
  return guarded(error, [&] { given(scene, "the scene").held.set_pose(object, pose_of(given(pose, "the pose"))); });
}

touchstone_status touchstone_scene_touches(const touchstone_scene* scene, const touchstone_ball* balls, size_t count,
                                           const touchstone_scene_options* options, bool* touches,
                                           touchstone_error* error) {
  return guarded(error, [&] {
    const auto asking = balls_of(balls, count);
    const std::span out = given(touches, count, "the array of answers");
    ask_scene(scene, options, count, [&](const Scene& held, const Scene::Objects& objects) {
      if (count == 1)
        out[0] = held.touches(asking[0], objects);
      else
        held.touches(asking, out, objects);
    });
  });
}

touchstone_status touchstone_scene_nearest(const touchstone_scene* scene, const touchstone_ball* balls, size_t count,
                                           const touchstone_scene_options* options, touchstone_nearest_face* faces,
                                           touchstone_error* error) {
  return guarded(error, [&] {
    const auto asking = balls_of(balls, count);
    ask_scene(scene, options, count, [&](const Scene& held, const Scene::Objects& objects) {
      answer_each(each_of(asking, [&](const auto& one_or_all) { return held.nearest(one_or_all, objects); }), faces,
                  [](const auto& nearest) { return converted(nearest); });
    });
  });
}

touchstone_status touchstone_scene_first_contact(const touchstone_scene* scene, const touchstone_motion* motions,
                                                 size_t count, const touchstone_scene_options* options,
                                                 touchstone_first_face* faces, touchstone_error* error) {
  return guarded(error, [&] {
    const auto asking = motions_of(motions, count);
    ask_scene(scene, options, count, [&](const Scene& held, const Scene::Objects& objects) {
      answer_each(each_of(asking, [&](const auto& one_or_all) { return held.first_contact(one_or_all, objects); }),
                  faces, [](const auto& first) { return converted(first); });
    });
  });
}

touchstone_status touchstone_scene_touched(const touchstone_scene* scene, const touchstone_ball* balls, size_t count,
                                           const touchstone_scene_options* options, touchstone_face_lists** lists,
                                           touchstone_error* error) {
  return created(lists, error, [&] {
    const auto asking = balls_of(balls, count);
    auto made = std::make_unique<touchstone_face_lists>();
    ask_scene(scene, options, count, [&](const Scene& held, const Scene::Objects& objects) {
      for (const auto& list :
           each_of(asking, [&](const auto& one_or_all) { return held.touched(one_or_all, objects); })) {
        for (const scene::FaceId& id : list) made->faces.push_back({id.object, id.face});
        made->offsets.push_back(made->faces.size());
      }
    });
    return made;
  });
}

const uint64_t* touchstone_face_lists_offsets(const touchstone_face_lists* lists) {
  return lists == nullptr ? nullptr : lists->offsets.data();
}

const touchstone_face_id* touchstone_face_lists_faces(const touchstone_face_lists* lists) {
  return lists == nullptr ? nullptr : lists->faces.data();
}

void touchstone_face_lists_free(touchstone_face_lists* lists) { delete lists; }

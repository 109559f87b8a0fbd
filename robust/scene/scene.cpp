// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/scene.h"

#include <algorithm>
#include <stdexcept>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/required.h"
#include "robust/scene/detail/crowd_parts.h"
#include "robust/scene/detail/object.h"
#include "robust/scene/detail/walks.h"
#include "robust/scene/posing.h"

namespace touchstone::scene {

using namespace detail;

namespace {

/// @{
/// Returns the walks of this machine for contact with a ball or a motion.
const ContactWalks<Ball>& walks_for(const Ball&) { return fastest_walks().ball; }
const ContactWalks<Motion>& walks_for(const Motion&) { return fastest_walks().motion; }
/// @}

}  // namespace

Scene::Objects::Objects(std::vector<std::uint32_t> numbers) : some_(std::move(numbers)) {
  std::sort(some_->begin(), some_->end());
  some_->erase(std::unique(some_->begin(), some_->end()), some_->end());
}

bool Scene::Objects::has(std::uint32_t number) const { return !some_ || std::ranges::binary_search(*some_, number); }

Scene::Scene() : index_(std::make_unique<Index>()) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

std::uint32_t Scene::add(std::string name, Faces faces, const Pose& pose) {
  const FloatingPointState nearest;
  if (index_->numbers.contains(name)) throw std::invalid_argument("there is already an object \"" + name + "\"");
  auto object = std::make_unique<const Object>(std::move(name), std::move(faces));
  if (!(pose == Pose())) object = moved(*object, pose);
  const auto number = static_cast<std::uint32_t>(objects_.size());
  objects_.push_back(nullptr);  // nothing is added if memory is exhausted here or below
  try {
    index_->boxes.set(number, object->box);
    index_->numbers.emplace(object->name, number);
  } catch (...) {
    objects_.pop_back();
    index_->boxes.set(number, Box());
    throw;
  }
  objects_.back() = std::move(object);
  return number;
}

void Scene::remove(std::uint32_t object) {
  const FloatingPointState nearest;
  const Object& old = at(object);
  index_->boxes.set(object, Box());
  index_->numbers.erase(old.name);
  objects_[object].reset();
}

std::unique_ptr<const Scene::Object> Scene::moved(const Object& object, const Pose& pose) {
  if (!is_finite(pose))
    throw Rejected(
        {RejectionCode::NotFinite, "object \"" + object.name + "\": the pose has a number that is not finite"});
  return std::make_unique<const Object>(object, pose);
}

void Scene::set_pose(std::uint32_t object, const Pose& pose) {
  const FloatingPointState nearest;
  const Object& before = at(object);
  std::unique_ptr<const Object> after = moved(before, pose);
  index_->boxes.set(object, after->box);
  objects_[object] = std::move(after);
}

const Scene::Object& Scene::at(std::uint32_t number) const {
  if (has(number)) return *objects_[number];
  if (number < objects_.size()) throw std::out_of_range("object " + std::to_string(number) + " was removed");
  throw std::out_of_range("there is no object " + std::to_string(number) + ": the scene has " +
                          std::to_string(objects_.size()));
}

void Scene::expect(const Objects& objects) const {
  if (!objects.some_) return;
  for (const std::uint32_t number : *objects.some_) (void)at(number);
}

const TriangleSet& Scene::triangles(std::uint32_t object) const { return at(object).triangles; }

const Pose& Scene::pose(std::uint32_t object) const { return at(object).pose; }

const std::string& Scene::name(std::uint32_t object) const { return at(object).name; }

std::uint32_t Scene::find(std::string_view name) const {
  if (const auto found = index_->numbers.find(name); found != index_->numbers.end()) return found->second;
  throw std::invalid_argument("there is no object \"" + std::string(name) + "\"");
}

std::size_t Scene::face_count(std::uint32_t object) const { return at(object).face_count(); }
std::size_t Scene::face_count(const Objects& objects) const {
  std::size_t count = 0;
  any_of(objects, [&](std::uint32_t, const Object& object) {
    count += object.face_count();
    return false;
  });
  return count;
}

std::size_t Scene::triangle_memory(std::uint32_t object) const { return at(object).triangles.memory(); }

template <class Query>
bool Scene::touches_any(const Query& query, const Objects& objects) const {
  const FloatingPointState nearest;
  const auto& walks = walks_for(query);
  return any_near(query, objects, [&](std::uint32_t, const Object& object) {
    return (object.has_triangles() && walks.touches_triangle(query, object.triangles)) ||
           (object.has_polygons() && walks.touches_polygon(query, object.polygons));
  });
}

template <class Query>
std::vector<FaceId> Scene::all_touched(const Query& query, const Objects& objects) const {
  const FloatingPointState nearest;
  const auto& walks = walks_for(query);
  std::vector<FaceId> result;
  any_near(query, objects, [&](std::uint32_t number, const Object& object) {
    if (object.has_triangles()) walks.touched_triangles(query, object.triangles, object.first_triangle(number), result);
    if (object.has_polygons()) walks.touched_polygons(query, object.polygons, object.first_polygon(number), result);
    return false;
  });
  const auto number = [](const FaceId& id) { return std::uint64_t{id.object} << 32 | id.face; };
  std::sort(result.begin(), result.end(), [&](const FaceId& a, const FaceId& b) { return number(a) < number(b); });
  return result;
}

bool Scene::touches(const Ball& ball, const Objects& objects) const {
  expect(objects);
  return touches_any(required(ball), objects);
}
std::vector<FaceId> Scene::touched(const Ball& ball, const Objects& objects) const {
  expect(objects);
  return all_touched(required(ball), objects);
}
void Scene::search_nearest(NearestSearch& search, std::uint32_t number, const Object& object) {
  search.enter(object.first_triangle(number));
  fastest_walks().nearest_triangle(object.triangles, search);
  search.enter(object.first_polygon(number));
  fastest_walks().nearest_polygon(object.polygons, search);
}
void Scene::search_nearest(NearestSearch& search, const Objects& objects) const {
  std::optional<std::uint32_t> first;
  if (by_boxes(objects)) {  // a guess, with which the ball shrinks before the boxes in its reach are found
    first = index_->boxes.nearest(search.ball().center, [&](std::uint32_t number) { return objects.has(number); });
    if (first) search_nearest(search, *first, *objects_[*first]);
  }
  any_near(search.ball(), objects, [&](std::uint32_t number, const Object& object) {
    if (number != first) search_nearest(search, number, object);
    return false;
  });
  if (search.has_shrunk()) return;
  // All faces are farther than the largest double or nearly so: balls cannot tell which matter.
  any_of(objects, [&](std::uint32_t number, const Object& object) {
    search.enter(object.first_triangle(number));
    const std::vector<std::uint32_t>& order = object.triangles.placed->tree.order();
    for (std::uint32_t place = 0; place < order.size(); ++place)
      if (order[place] != BoxTree::kNone) search.meet(object.triangles.triangle(place), order[place]);
    search.enter(object.first_polygon(number));
    for (std::uint32_t i = 0; i < object.polygons.polygons.size(); ++i) search.meet(object.polygons.prepared[i], i);
    return false;
  });
}
std::optional<NearestFace> Scene::nearest(const Ball& ball, const Objects& objects) const {
  expect(objects);
  const FloatingPointState nearest;
  NearestSearch search(required(ball));
  search_nearest(search, objects);
  return search.nearest();
}
std::optional<FaceId> Scene::nearest_face(const Eigen::Vector3d& center, const Objects& objects) const {
  expect(objects);
  const FloatingPointState nearest;
  NearestSearch search(required(Ball{center, 0}));
  search_nearest(search, objects);
  return search.nearest_face();
}

bool Scene::touches(const Motion& motion, const Objects& objects) const {
  const FloatingPointState nearest;  // at_rest compares doubles
  if (required(motion).at_rest()) return touches(motion.ball, objects);
  expect(objects);
  return touches_any(motion, objects);
}
std::vector<FaceId> Scene::touched(const Motion& motion, const Objects& objects) const {
  const FloatingPointState nearest;  // at_rest compares doubles
  if (required(motion).at_rest()) return touched(motion.ball, objects);
  expect(objects);
  return all_touched(motion, objects);
}
template <class Search>
void Scene::search_on_way(Search& search, const Motion& motion, const Objects& objects) const {
  expect(objects);
  const auto ask = [&](std::uint32_t number, const Object& object) {
    if (object.has_triangles()) {
      search.enter(object.first_triangle(number));
      fastest_walks().first_triangle(object.triangles, search);
    }
    if (object.has_polygons()) {
      search.enter(object.first_polygon(number));
      fastest_walks().first_polygon(object.polygons, search);
    }
    return false;
  };
  if (by_boxes(objects)) {
    for (const auto& [number, earliest] : index_->boxes.on_way(motion)) {
      if (earliest > search.end()) break;
      if (objects.has(number)) ask(number, *objects_[number]);
    }
  } else {
    any_of(objects, ask);
  }
}
std::vector<FirstFace> Scene::touched_in_order(const Motion& motion, const Objects& objects) const {
  const FloatingPointState nearest;
  FirstContactSearch search(required(motion), FirstContactSearch::Wanted::All);
  search_on_way(search, motion, objects);
  return search.all_in_order();
}
std::optional<FirstFace> Scene::first_contact(const Motion& motion, const Objects& objects) const {
  const FloatingPointState nearest;
  FirstContactSearch search(required(motion));
  search_on_way(search, motion, objects);
  return search.first();
}

void Scene::touches(std::span<const Motion> motions, std::span<bool> answers, const Objects& objects) const {
  const FloatingPointState state;  // TBB clears the exception flags where it changes the rounding mode
  expect(objects);
  expect_equal_lengths("motions", motions.size(), "answers", answers.size());
  each_motion(motions, face_count(objects), [&](std::size_t i) { answers[i] = touches(motions[i], objects); });
}
template <class Answer>
std::vector<Answer> Scene::answers_to(std::span<const Motion> motions, const Objects& objects,
                                      Answer (Scene::*answer)(const Motion&, const Objects&) const) const {
  const FloatingPointState state;
  expect(objects);
  std::vector<Answer> answers(motions.size());
  each_motion(motions, face_count(objects), [&](std::size_t i) { answers[i] = (this->*answer)(motions[i], objects); });
  return answers;
}
std::vector<std::vector<FaceId>> Scene::touched(std::span<const Motion> motions, const Objects& objects) const {
  return answers_to<std::vector<FaceId>>(motions, objects, &Scene::touched);
}
std::vector<std::vector<FirstFace>> Scene::touched_in_order(std::span<const Motion> motions,
                                                            const Objects& objects) const {
  return answers_to<std::vector<FirstFace>>(motions, objects, &Scene::touched_in_order);
}
std::vector<std::optional<FirstFace>> Scene::first_contact(std::span<const Motion> motions,
                                                           const Objects& objects) const {
  return answers_to<std::optional<FirstFace>>(motions, objects, &Scene::first_contact);
}

}  // namespace touchstone::scene

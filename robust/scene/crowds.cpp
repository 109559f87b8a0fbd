// SPDX-License-Identifier: Apache-2.0
// The questions of Scene about many balls, which walk through the trees together.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/detail/floating_point_state.h"
#include "geometry/detail/parts_in_parallel.h"
#include "geometry/detail/required.h"
#include "robust/scene/detail/crowd_parts.h"
#include "robust/scene/detail/each_ball.h"
#include "robust/scene/detail/nearest_search.h"
#include "robust/scene/detail/object.h"
#include "robust/scene/detail/walks.h"
#include "robust/scene/scene.h"

namespace touchstone::scene {

using namespace detail;

namespace {

/// Returns whether there are at most `most` faces, of one object, whose numbers fit into 32 bits with a sign.
bool are_few(std::span<const TouchedFace> faces, std::size_t most) {
  constexpr std::uint32_t kLargest = std::numeric_limits<std::int32_t>::max();
  return faces.size() <= most && std::all_of(faces.begin(), faces.end(), [&](const TouchedFace& face) {
           return face.face.object == faces.front().face.object && face.face.face < kLargest;
         });
}

/// Writes the faces that a ball touches, ascending. They mostly are few and of one object: then each is put where the
/// number of lower ones tells, without a branch.
void sort_faces(std::span<const TouchedFace> faces, std::vector<FaceId>& sorted) {
  constexpr std::size_t kFew = 16;
  sorted.resize(faces.size());
  if (are_few(faces, kFew)) {
    std::int32_t numbers[kFew];
    std::fill_n(numbers, kFew, std::numeric_limits<std::int32_t>::max());
    for (std::size_t i = 0; i < faces.size(); ++i) numbers[i] = static_cast<std::int32_t>(faces[i].face.face);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::int32_t lower = 0;
      for (const std::int32_t other : numbers) lower += other < numbers[i] ? 1 : 0;
      sorted[static_cast<std::size_t>(lower)] = faces[i].face;
    }
    return;
  }
  std::transform(faces.begin(), faces.end(), sorted.begin(), [](const TouchedFace& face) { return face.face; });
  std::sort(sorted.begin(), sorted.end());
}

}  // namespace

void Scene::touches(std::span<const Ball> balls, std::span<bool> answers, const Objects& objects) const {
  const FloatingPointState nearest;
  expect(objects);
  expect_equal_lengths("balls", balls.size(), "answers", answers.size());
  if (!is_crowd(balls.size(), kFewestTouching, count_of(objects))) {
    each_in_parallel(balls.size(), kAloneAtOnce, [&](std::size_t i) { answers[i] = touches(balls[i], objects); });
    return;
  }
  each_crowd(balls, kFewestTouching, [&](std::span<const std::uint32_t> numbers, std::span<const Ball> crowd) {
    std::vector<std::uint8_t> touches(crowd.size(), 0);
    any_of(objects, [&](std::uint32_t, const Object& object) {
      if (object.has_triangles()) fastest_walks().crowd.touches_triangle(crowd, object.triangles, touches);
      if (object.has_polygons())
        for (std::size_t i = 0; i < crowd.size(); ++i)
          if (touches[i] == 0) touches[i] = fastest_walks().ball.touches_polygon(crowd[i], object.polygons) ? 1 : 0;
      return false;
    });
    for (std::size_t i = 0; i < crowd.size(); ++i) answers[numbers[i]] = touches[i] != 0;
  });
}

std::vector<std::vector<FaceId>> Scene::touched(std::span<const Ball> balls, const Objects& objects) const {
  const FloatingPointState nearest;
  expect(objects);
  std::vector<std::vector<FaceId>> answers(balls.size());
  if (!is_crowd(balls.size(), kFewestTouching, count_of(objects))) {
    each_in_parallel(balls.size(), kAloneAtOnce, [&](std::size_t i) { answers[i] = touched(balls[i], objects); });
    return answers;
  }
  each_crowd(balls, kFewestTouching, [&](std::span<const std::uint32_t> numbers, std::span<const Ball> crowd) {
    std::vector<TouchedFace> faces;
    std::vector<FaceId> of_polygons;
    any_of(objects, [&](std::uint32_t number, const Object& object) {
      if (object.has_triangles())
        fastest_walks().crowd.touched_triangles(crowd, object.triangles, object.first_triangle(number), faces);
      if (object.has_polygons())
        for (std::uint32_t i = 0; i < crowd.size(); ++i) {
          of_polygons.clear();
          fastest_walks().ball.touched_polygons(crowd[i], object.polygons, object.first_polygon(number), of_polygons);
          for (const FaceId& face : of_polygons) faces.push_back({i, face});
        }
      return false;
    });
    each_ball(crowd.size(), std::span<const TouchedFace>(faces),
              [&](std::size_t i, std::span<const TouchedFace> of_ball) { sort_faces(of_ball, answers[numbers[i]]); });
  });
  return answers;
}

template <class OnlyOne, class Answer>
void Scene::nearest_each(std::span<const Ball> balls, const Objects& objects, const OnlyOne& only_one,
                         const Answer& answer) const {
  if (!is_crowd(balls.size(), kFewestSearching, count_of(objects))) {
    each_in_parallel(balls.size(), kAloneAtOnce, [&](std::size_t i) {
      NearestSearch search(required(balls[i]));
      search_nearest(search, objects);
      answer(i, search);
    });
    return;
  }
  each_crowd(balls, kFewestSearching, [&](std::span<const std::uint32_t> numbers, std::span<const Ball> crowd) {
    std::vector<double> radii(crowd.size(), std::numeric_limits<double>::max());
    std::vector<PlaceOfBall> places;
    bool polygons = false;
    any_of(objects, [&](std::uint32_t number, const Object& object) {
      if (object.has_triangles())
        fastest_walks().crowd.nearest_triangles(crowd, object.triangles, number, radii, places);
      polygons = polygons || object.has_polygons();
      return false;
    });
    const auto face = [&](const PlaceOfBall& of_ball) {
      return FaceId{of_ball.object, objects_[of_ball.object]->triangles.placed->tree.order()[of_ball.place]};
    };
    each_ball(
        crowd.size(), std::span<const PlaceOfBall>(places), [&](std::size_t i, std::span<const PlaceOfBall> of_ball) {
          if (of_ball.size() == 1 && !polygons && !std::isnan(radii[i]) && only_one(numbers[i], face(of_ball.front())))
            return;
          NearestSearch search(crowd[i]);
          if (std::isnan(radii[i]) || of_ball.empty()) {
            search_nearest(search, objects);
          } else {
            search.shrink(radii[i]);
            for (const PlaceOfBall& here : of_ball) {
              search.enter(Object::first_triangle(here.object));
              search.meet(objects_[here.object]->triangles.triangle(here.place), face(here).face);
            }
            if (polygons)
              any_of(objects, [&](std::uint32_t number, const Object& object) {
                search.enter(object.first_polygon(number));
                fastest_walks().nearest_polygon(object.polygons, search);
                return false;
              });
          }
          answer(numbers[i], search);
        });
  });
}

void Scene::nearest(std::span<const Ball> balls, const TakeNearest& take, const Objects& objects) const {
  const FloatingPointState state;
  expect(objects);
  nearest_each(
      balls, objects, [](std::size_t, const FaceId&) { return false; },
      [&](std::size_t i, NearestSearch& search) { take(i, search.nearest()); });
}

std::vector<std::optional<NearestFace>> Scene::nearest(std::span<const Ball> balls, const Objects& objects) const {
  std::vector<std::optional<NearestFace>> answers(balls.size());
  nearest(
      balls, [&](std::size_t i, const std::optional<NearestFace>& face) { answers[i] = face; }, objects);
  return answers;
}

std::vector<std::optional<FaceId>> Scene::nearest_face(std::span<const Eigen::Vector3d> centers,
                                                       const Objects& objects) const {
  const FloatingPointState state;
  expect(objects);
  std::vector<Ball> points;
  points.reserve(centers.size());
  for (const Eigen::Vector3d& center : centers) points.push_back({center, 0});
  std::vector<std::optional<FaceId>> answers(centers.size());
  const auto only_one = [&](std::size_t i, const FaceId& face) {
    answers[i] = face;
    return true;
  };
  nearest_each(points, objects, only_one,
               [&](std::size_t i, NearestSearch& search) { answers[i] = search.nearest_face(); });
  return answers;
}

}  // namespace touchstone::scene

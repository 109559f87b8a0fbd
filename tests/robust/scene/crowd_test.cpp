// SPDX-License-Identifier: GPL-3.0-or-later
// Many balls that walk through a scene together get the answers of single ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>

#include "robust/filtered/detail/sets/eight_balls.h"
#include "robust/scene/detail/crowd_parts.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/printing.h"

namespace touchstone::scene_tests {
namespace {

using scene::Scene;

std::vector<Ball> draw_balls(const std::vector<Polygon>& all, std::uint64_t count, std::uint64_t seed) {
  std::vector<Ball> balls;
  for (std::uint64_t i = 0; i < count; ++i) balls.push_back(draw_ball(all, seed, i));
  return balls;
}

/// Returns how many balls walk together on this machine in a question for which `fewest` are enough on one core.
std::size_t crowd_of(std::size_t fewest) { return fewest * std::max(1U, std::thread::hardware_concurrency()); }

/// Returns the balls, again and again until they walk together in such a question.
std::vector<Ball> repeated(const std::vector<Ball>& balls, std::size_t fewest) {
  std::vector<Ball> many;
  while (!balls.empty() && many.size() < crowd_of(fewest)) many.insert(many.end(), balls.begin(), balls.end());
  return many;
}

std::vector<Eigen::Vector3d> centers_of(const std::vector<Ball>& balls) {
  std::vector<Eigen::Vector3d> centers;
  for (const Ball& ball : balls) centers.push_back(ball.center);
  return centers;
}

void expect_single_answers(const Scene& scene, const std::vector<Ball>& balls, const std::string& what,
                           const Scene::Objects& objects = {}) {
  const std::vector<Ball> asking = repeated(balls, scene::detail::kFewestTouching);
  const std::unique_ptr<bool[]> touches(new bool[asking.size()]);
  scene.touches(asking, {touches.get(), asking.size()}, objects);
  const auto touched = scene.touched(asking, objects);
  const std::vector<Ball> searching = repeated(balls, scene::detail::kFewestSearching);
  const auto nearest = scene.nearest(searching, objects);
  const auto faces = scene.nearest_face(centers_of(searching), objects);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const std::string ball = what + ", ball " + std::to_string(i) + " of " + std::to_string(balls.size());
    const bool touches_any = scene.touches(balls[i], objects);
    const auto all_touched = scene.touched(balls[i], objects);
    bool as_alone = true;
    for (std::size_t same = i; same < asking.size(); same += balls.size())
      as_alone = as_alone && touches[same] == touches_any && touched[same] == all_touched;
    EXPECT_TRUE(as_alone) << ball;
    const auto expected = scene.nearest(balls[i], objects);
    const auto face = expected ? std::optional(expected->face) : std::nullopt;
    EXPECT_EQ(scene.nearest_face(balls[i].center, objects), face) << ball;
    for (std::size_t same = i; same < searching.size(); same += balls.size()) {
      EXPECT_EQ(nearest[same], expected) << ball;
      EXPECT_EQ(faces[same], face) << ball;
    }
  }
}

TEST(Crowd, GetsTheAnswersOfSingleBalls) {
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < 2; ++index) {
      const int times = index == 1 ? 4 : 1;
      const Subject subject(draw_objects(kind, 2027, index, times), name(kind) + " " + std::to_string(index));
      const std::vector<Ball> balls = draw_balls(subject.faces.polygons(), 200, 100 + index);
      expect_single_answers(subject.built, balls, subject.what);
      if (index == 0)
        expect_single_answers(subject.built, balls, subject.what + ", some", std::vector<std::uint32_t>{0, 2});
    }
}

// Fewer than a crowd, and parts of a crowd that are not full.
TEST(Crowd, GetsTheAnswersOfSingleBallsWhateverItsNumber) {
  const Subject subject(draw_objects(Kind::Soup, 2027, 7), "soup");
  const std::vector<Ball> few = draw_balls(subject.faces.polygons(), 100, 7);
  const auto less = [](const std::vector<Ball>& balls, std::size_t left_out) {
    return std::span(balls).first(balls.size() - left_out);
  };
  for (const std::size_t left_out : {0U, 1U, 77U, 99U, 101U, 1000U}) {
    const std::vector<Ball> many = repeated(few, scene::detail::kFewestTouching);
    const auto balls = less(many, left_out);
    const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
    subject.built.touches(balls, {touches.get(), balls.size()});
    const auto touched = subject.built.touched(balls);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      ASSERT_EQ(touches[i], subject.built.touches(balls[i])) << i << " of " << balls.size();
      ASSERT_EQ(touched[i], subject.built.touched(balls[i])) << i << " of " << balls.size();
    }
  }
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 127U, 128U, 129U, 1100U}) {
    const std::vector<Ball> balls = draw_balls(subject.faces.polygons(), count, 7);
    const auto nearest = subject.built.nearest(balls);
    ASSERT_EQ(nearest.size(), count);
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(nearest[i], subject.built.nearest(balls[i])) << i << " of " << count;
  }
}

TEST(Crowd, GetsTheAnswersOfSingleBallsAboutPosedObjects) {
  for (const Kind kind : all_kinds())
    for (std::uint64_t index = 0; index < 2; ++index) {
      const auto models = draw_objects(kind, 2027, index);
      Scene scene;
      std::vector<scene::Faces> standing;
      for (std::uint32_t i = 0; i < models.size(); ++i) {
        const std::uint32_t object = scene.add(std::to_string(i), models[i]);
        standing.push_back(models[i]);
        for (std::uint64_t step = 0; step < 3; ++step) try {
            const Pose pose = draw_pose({models[i]}, 2027, 100 * index + 10 * step + i);
            scene.set_pose(object, pose);
            standing.back() = posed(pose, models[i]);
          } catch (const Rejected&) {
          }
      }
      expect_single_answers(scene, draw_balls(all_polygons(standing), 200, 200 + index), name(kind));
    }
}

// So far away rounding moves vertices by up to 2^-13. In the object's own frame each ball is therefore seen as one that
// surely holds it, larger by more than 2^-14.
TEST(Crowd, DoesNotTouchWhatOnlyALargerBallTouchesInItsOwnFrame) {
  Scene scene;
  scene.add("far away", {{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}, {}},
            Pose{Eigen::Matrix3d::Identity(), {0x1p40, 0, 0}});
  const std::vector<Ball> balls =
      repeated({{{0x1p40, 0, 1}, 1}, {{0x1p40, 0, 1 + 0x1p-14}, 1}}, scene::detail::kFewestTouching);
  const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
  scene.touches(balls, {touches.get(), balls.size()});
  const auto touched = scene.touched(balls);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    ASSERT_EQ(touches[i], i % 2 == 0) << i;
    ASSERT_EQ(touched[i].size(), i % 2 == 0 ? 1U : 0U) << i;
  }
}

// Beyond what floats cull by, beyond the reach of groups, and both in one crowd with balls that are not.
TEST(Crowd, HoldsBallsOfAllSizes) {
  const Subject subject(draw_objects(Kind::Soup, 2027, 3), "soup");
  std::vector<Ball> balls = draw_balls(subject.faces.polygons(), 64, 3);
  for (const double far : {0x1p30, 0x1p60, 0x1p500, 0x1p1000, 0x1p1023})
    for (int axis = 0; axis < 3; ++axis) {
      Ball ball = balls[static_cast<std::size_t>(axis)];
      ball.center[axis] = far;
      balls.push_back(ball);
      ball.radius = far;
      balls.push_back(ball);
      ball.center = balls[static_cast<std::size_t>(axis)].center;
      balls.push_back(ball);
    }
  expect_single_answers(subject.built, balls, "soup");
  Scene turned;  // in its own frame, which sees no centre that is too far away
  scene::Faces soup = draw_objects(Kind::Soup, 2027, 3)[0];
  Pose pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  turned.add("soup", std::move(soup), pose);
  expect_single_answers(turned, balls, "turned soup");
}

TEST(Crowd, OfAnEmptySceneTouchesNothing) {
  Scene scene;
  expect_single_answers(scene, std::vector<Ball>(100, Ball{{0, 0, 0}, 1}), "no object");
  scene.add("nothing", {});
  expect_single_answers(scene, std::vector<Ball>(100, Ball{{0, 0, 0}, 1}), "an object without faces");
}

// Many centres at one place, above the vertex that six triangles share: all are nearest.
TEST(Crowd, NamesTheLowestOfEquals) {
  Scene scene;
  scene::Faces fan;
  const Eigen::Vector3d around[] = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  for (std::size_t i = 0; i < 6; ++i) fan.triangles.push_back({{0, 0, 1}, around[i], around[(i + 1) % 6]});
  scene.add("fan", fan);
  scene.add("again", fan);
  const std::vector<Eigen::Vector3d> centers(crowd_of(scene::detail::kFewestSearching), {0, 0, 3});
  for (const auto& face : scene.nearest_face(centers)) EXPECT_EQ(face, (scene::FaceId{0, 0}));
}

TEST(Crowd, FindsThePolygonsOfEveryObject) {
  Scene scene;
  scene.add("square", {{}, {Polygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}})}});
  scene.add("triangle", {{{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}}}, {}});
  for (const auto& face :
       scene.nearest_face(std::vector<Eigen::Vector3d>(crowd_of(scene::detail::kFewestSearching), {0, 0, 1})))
    EXPECT_EQ(face, (scene::FaceId{0, 0}));
}

// Its triangle is a quarter as far in its own frame.
TEST(Crowd, FindsTheNearestTriangleOfAnObjectThatItsPoseEnlarges) {
  Scene scene;
  const Triangle triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  scene.add("below", {{triangle}, {}}, Pose{Eigen::Matrix3d::Identity(), {0, 0, -10}});
  scene.add("enlarged", {{triangle}, {}}, Pose{4 * Eigen::Matrix3d::Identity(), {0, 0, 9}});
  for (const auto& face :
       scene.nearest_face(std::vector<Eigen::Vector3d>(crowd_of(scene::detail::kFewestSearching), {0, 0, 0})))
    EXPECT_EQ(face, (scene::FaceId{1, 0}));
}

void expect_each_once(const Scene& scene, const std::vector<Ball>& balls) {
  std::vector<std::atomic<int>> times(balls.size());
  scene.nearest(balls, [&](std::size_t i, const std::optional<scene::NearestFace>& face) {
    ++times[i];
    EXPECT_EQ(face, scene.nearest(balls[i]));
  });
  for (const std::atomic<int>& taken : times) EXPECT_EQ(taken, 1);
}

TEST(Crowd, PassesEachNearestFaceOnOnce) {
  const Subject subject(draw_objects(Kind::Soup, 2027, 5), "soup");
  for (const std::uint64_t count : {0UL, 5UL, 3 * crowd_of(scene::detail::kFewestSearching)})
    expect_each_once(subject.built, draw_balls(subject.faces.polygons(), count, 5));
  expect_each_once(Scene(), std::vector<Ball>(100, Ball{{0, 0, 0}, 1}));
}

TEST(Crowd, EndsWithTheExceptionOfWhoTakesAnAnswer) {
  const Subject subject(draw_objects(Kind::Soup, 2027, 5), "soup");
  for (const std::uint64_t count : {5UL, 3 * crowd_of(scene::detail::kFewestSearching)})
    EXPECT_THROW(subject.built.nearest(draw_balls(subject.faces.polygons(), count, 5),
                                       [](std::size_t, const auto&) { throw std::length_error("full"); }),
                 std::length_error);
}

TEST(AlongCurve, IsAPermutationOfAnyBalls) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const Subject subject(draw_objects(Kind::MixedSizes, 2027, 1), "mixed");
  for (std::vector<Ball> balls :
       {draw_balls(subject.faces.polygons(), 500, 1), std::vector<Ball>(50, Ball{{1, 2, 3}, 1}),
        std::vector<Ball>{{{-kLargest, 0, 0}, 0}, {{kLargest, 0, 0}, 0}, {{0, 0, 0}, 0}}, std::vector<Ball>{}}) {
    std::vector<std::uint32_t> order = scene::detail::along_curve(balls), expected(balls.size());
    std::iota(expected.begin(), expected.end(), 0U);
    std::ranges::sort(order);
    EXPECT_EQ(order, expected);
  }
}

// The eight corners of a cube come octant by octant.
TEST(AlongCurve, KeepsNeighboursTogether) {
  std::vector<Ball> balls;
  for (std::uint32_t i = 0; i < 64; ++i) balls.push_back({{i % 4 / 4.0, i / 4 % 4 / 4.0, i / 16 / 4.0}, 0});
  const std::vector<std::uint32_t> order = scene::detail::along_curve(balls);
  for (std::size_t i = 0; i < 64; ++i) {
    const Eigen::Vector3d place = balls[order[i]].center, first = balls[order[i / 8 * 8]].center;
    EXPECT_LE((place - first).lpNorm<Eigen::Infinity>(), 0.25) << i;
  }
}

TEST(EightMasks, TurnBytesOfTrianglesIntoBytesOfBalls) {
  for (unsigned triangle = 0; triangle < 8; ++triangle)
    for (unsigned ball = 0; ball < 8; ++ball) {
      filtered::detail::EightMasks masks;
      masks.set(triangle, 1U << ball);
      masks.turn();
      for (unsigned other = 0; other < 8; ++other)
        EXPECT_EQ(masks.of(other), other == ball ? 1U << triangle : 0U) << triangle << ' ' << ball;
    }
}

}  // namespace
}  // namespace touchstone::scene_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of many objects, which are found by their boxes, answer as their faces do one by one.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "experiments/cases/workloads/random.h"
#include "robust/scene/detail/object_boxes.h"
#include "robust/scene/posing.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/printing.h"

namespace touchstone::scene_tests {
namespace {

using scene::FaceId;
using scene::Faces;
using scene::Scene;
using scene::detail::ObjectBoxes;
using workloads::Random;

/// Objects of one face each.
std::vector<Faces> split(const std::vector<Faces>& objects) {
  std::vector<Faces> single;
  for (const Faces& faces : objects) {
    for (const Triangle& triangle : faces.triangles) single.push_back({{triangle}, {}});
    for (const Polygon& polygon : faces.polygons) single.push_back({{}, {polygon}});
  }
  return single;
}

/// Objects of one face each under poses, and the same faces where they stand. Removed ones have none.
class ManyObjects {
 public:
  ManyObjects(Kind kind, std::uint64_t index) : index_(index), models_(split(draw_objects(kind, 2028, index))) {
    for (const Faces& model : models_) scene_.add(std::to_string(scene_.object_count()), model);
    standing_ = models_;
    pose_every(3, 0);
  }
  void pose_every(std::uint32_t step, std::uint64_t round) {
    for (std::uint32_t i = 0; i < models_.size(); i += step) try {
        if (!scene_.has(i)) continue;
        const Pose pose = draw_pose({models_[i]}, 2028, 10'000 * round + 1'000'000 * index_ + i);
        scene_.set_pose(i, pose);
        standing_[i] = posed(pose, models_[i]);
      } catch (const Rejected&) {
      }
  }
  void remove_every(std::uint32_t step) {
    for (std::uint32_t i = 1; i < models_.size(); i += step) {
      if (!scene_.has(i)) continue;
      scene_.remove(i);
      standing_[i] = {};
    }
  }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Faces>& standing() const { return standing_; }

 private:
  std::uint64_t index_;
  std::vector<Faces> models_, standing_;
  Scene scene_;
};

std::vector<FaceId> of_even_objects(std::vector<FaceId> faces) {
  std::erase_if(faces, [](const FaceId& id) { return id.object % 2 != 0; });
  return faces;
}

void expect_answers_of_single_faces(const ManyObjects& objects, std::uint64_t seed, const std::string& what) {
  const Scene& scene = objects.scene();
  const BruteForce faces(objects.standing());
  std::vector<std::uint32_t> even;
  for (std::uint32_t i = 0; i < scene.object_count(); i += 2)
    if (scene.has(i)) even.push_back(i);
  std::vector<Ball> balls;
  for (std::uint64_t i = 0; i < 70; ++i) {
    const Ball ball = draw_ball(faces.polygons(), seed, i);
    const Motion motion = draw_motion(faces.polygons(), seed, i);
    const std::string query = what + ", query " + std::to_string(i);
    const std::vector<FaceId> expected = faces.touched(ball), on_way = faces.touched(motion);
    EXPECT_EQ(scene.touched(ball), expected) << query;
    EXPECT_EQ(scene.touches(ball), !expected.empty()) << query;
    EXPECT_EQ(scene.touched(ball, even), of_even_objects(expected)) << query;
    EXPECT_EQ(scene.touched(motion), on_way) << query;
    EXPECT_EQ(scene.touches(motion, even), !of_even_objects(on_way).empty()) << query;
    EXPECT_EQ(scene.first_contact(motion), faces.first(motion)) << query;
    EXPECT_EQ(scene.touched_in_order(motion).size(), on_way.size()) << query;
    EXPECT_EQ(scene.nearest(ball), faces.nearest_by_exact(ball)) << query;
    EXPECT_EQ(scene.nearest_face(ball.center), faces.nearest_by_exact(ball).face) << query;
    const auto nearest_even = scene.nearest(ball, even);
    ASSERT_TRUE(nearest_even) << query;
    EXPECT_EQ(nearest_even->face.object % 2, 0U) << query;
    balls.push_back(ball);
  }
  const auto touched = scene.touched(balls);
  const auto nearest = scene.nearest(balls);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_EQ(touched[i], faces.touched(balls[i])) << what << ", ball " << i;
    EXPECT_EQ(nearest[i], scene.nearest(balls[i])) << what << ", ball " << i;
  }
}

TEST(ManyObjects, AnswerAsTheirFacesDoWhereverTheyAreMoved) {
  int asked = 0;
  for (const Kind kind : all_kinds()) {
    ManyObjects objects(kind, 0);
    if (objects.standing().size() < 40) continue;  // too few to be found by their boxes
    ++asked;
    expect_answers_of_single_faces(objects, 1, name(kind));
    objects.pose_every(2, 1);
    objects.remove_every(4);
    expect_answers_of_single_faces(objects, 2, name(kind) + ", moved");
    objects.pose_every(1, 2);
    expect_answers_of_single_faces(objects, 3, name(kind) + ", moved again");
  }
  EXPECT_GE(asked, 5);
}

TEST(ManyObjects, AreWhereTheirPosesPutThem) {
  Scene scene;
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Pose pose;
  for (int i = 0; i < 100; ++i) {
    pose.translation.x() = 10.0 * i;
    scene.add(std::to_string(i), {{triangle}, {}}, pose);
  }
  EXPECT_EQ(scene.touched(Ball{{500, 0, 1}, 1}), (std::vector<FaceId>{{50, 0}}));
  pose.translation.x() = 500;
  scene.set_pose(7, pose);
  EXPECT_EQ(scene.touched(Ball{{500, 0, 1}, 1}), (std::vector<FaceId>{{7, 0}, {50, 0}}));
  EXPECT_FALSE(scene.touches(Ball{{70, 0, 1}, 1}));
  scene.remove(50);
  EXPECT_EQ(scene.touched(Ball{{500, 0, 1}, 1}), (std::vector<FaceId>{{7, 0}}));
  EXPECT_EQ(scene.nearest_face({440, 0, 0}), (FaceId{44, 0}));
}

TEST(RemovedObject, LeavesItsNameAndNotItsNumber) {
  Scene scene;
  const Faces faces{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {}};
  scene.add("a", faces);
  scene.add("b", faces);
  scene.remove(0);
  EXPECT_FALSE(scene.has(0));
  EXPECT_EQ(scene.touched(Ball{{0, 0, 1}, 1}), (std::vector<FaceId>{{1, 0}}));
  EXPECT_THROW((void)scene.find("a"), std::invalid_argument);
  EXPECT_THROW((void)scene.name(0), std::out_of_range);
  EXPECT_THROW((void)scene.touches(Ball{{0, 0, 1}, 1}, std::vector<std::uint32_t>{0, 1}), std::out_of_range);
  EXPECT_THROW(scene.remove(0), std::out_of_range);
  EXPECT_THROW(scene.set_pose(0, Pose()), std::out_of_range);
  EXPECT_EQ(scene.add("a", faces), 2U);
  EXPECT_EQ(scene.object_count(), 3U);
  EXPECT_EQ(scene.nearest_face({0, 0, 1}), (FaceId{1, 0}));
}

Box draw_box(std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, 97);
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = std::ldexp(2 * random.unit() - 1, static_cast<int>(random.integer(-3, 3)));
    // Boxes that are neighbours by one double, or the same, are told apart.
    const double b = random.unit() < 0.5 ? std::nextafter(a, 10) : a + random.unit();
    box.low[axis] = a, box.high[axis] = b;
  }
  return box;
}

TEST(ObjectBoxes, AreFoundIfTheyAreInReach) {
  constexpr std::uint32_t kNumbers = 300;
  ObjectBoxes boxes;
  std::vector<Box> all(kNumbers);
  Random random(2028, 0, 98);
  for (std::uint64_t step = 0; step < 5000; ++step) {
    const auto number = static_cast<std::uint32_t>(random.integer(0, kNumbers - 1));
    all[number] = random.unit() < 0.3 ? Box() : draw_box(2028, step);
    boxes.set(number, all[number]);
    const Box asked = draw_box(2029, step);
    const scene::detail::BoxesInReach reach(Ball{asked.low, random.unit()});
    const ObjectBoxes::Numbers found = boxes.in_reach(reach);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < kNumbers; ++i)
      if (!all[i].empty() && reach.has(all[i])) expected.push_back(i);
    EXPECT_TRUE(std::ranges::equal(found, expected)) << "step " << step;
    EXPECT_LE(boxes.height(), 12) << "step " << step;  // 1.45 log2(300)
  }
}

// Against the exact distance after a drawn part of the way. The box that the ball touches there is hidden among others.
TEST(ObjectBoxes, AreFoundOnTheWayOfABallNotTooLate) {
  int found_early = 0, others = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    Random random(2028, i, 102);
    const int scale = static_cast<int>(random.integer(-1020, 1015));
    Box touched = draw_box(2032, i);
    Eigen::Vector3d way, corner = random.unit() < 0.5 ? touched.low : touched.high;
    for (double& x : way) x = random.unit() < 0.2 ? 0 : std::ldexp(2 * random.unit() - 1, 6);
    for (double& x : corner) x += random.unit() < 0.3 ? 0 : 2 * random.unit() - 1;
    const double eighths = static_cast<double>(random.integer(0, 8));
    const Eigen::Vector3d from = corner - eighths / 8 * way, to = corner + (1 - eighths / 8) * way;
    mpq_class square = 0;  // of the distance then
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class center = (mpq_class(from[axis]) * (8 - eighths) + mpq_class(to[axis]) * eighths) / 8;
      const mpq_class gap =
          std::max<mpq_class>({mpq_class(touched.low[axis]) - center, center - mpq_class(touched.high[axis]), 0});
      square += gap * gap;
    }
    double radius = std::sqrt(square.get_d());
    while (mpq_class(radius) * mpq_class(radius) < square) radius = std::nextafter(radius, 10);
    const auto scaled = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
      return {std::ldexp(point.x(), scale), std::ldexp(point.y(), scale), std::ldexp(point.z(), scale)};
    };
    const Motion motion({scaled(from), std::ldexp(radius, scale)}, scaled(to));
    if (scale < -1000 && motion.ball.radius != 0) continue;  // scaling rounds
    ObjectBoxes boxes;
    constexpr std::uint32_t kBoxes = 8;
    for (std::uint32_t k = 0; k < kBoxes; ++k) {
      const Box box = k == 3 ? touched : draw_box(2033, kBoxes * i + k);
      boxes.set(k, {scaled(box.low), scaled(box.high)});
    }
    const auto found = boxes.on_way(motion);
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, &ObjectBoxes::OnWay::earliest)) << i;
    const auto it = std::ranges::find(found, 3U, &ObjectBoxes::OnWay::number);
    ASSERT_NE(it, found.end()) << i;
    EXPECT_LE(it->earliest, eighths / 8) << i;
    found_early += it->earliest > 0 ? 1 : 0;
    others += static_cast<int>(found.size()) - 1;
  }
  EXPECT_GT(found_early, 500) << "times are not computed";
  EXPECT_LT(others, 5 * 4000) << "nothing is left out";
}

TEST(ObjectBoxes, BesideALongWayAreLeftOut) {
  ObjectBoxes boxes;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Eigen::Vector3d low(i, 99 - i, 49);
    boxes.set(i, {low, low + Eigen::Vector3d::Ones()});
  }
  const auto found = boxes.on_way(Motion({{0, 0, 0}, 1}, {100, 100, 100}));
  EXPECT_GE(found.size(), 2U);
  EXPECT_LE(found.size(), 6U);
}

TEST(ObjectBoxes, NameTheNearestThatIsWanted) {
  ObjectBoxes boxes;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Eigen::Vector3d low(i, 0, 0);
    boxes.set(i, {low, low + Eigen::Vector3d::Constant(0.5)});
  }
  EXPECT_EQ(boxes.nearest({40.7, 0, 0}, [](std::uint32_t) { return true; }), 40U);
  EXPECT_EQ(boxes.nearest({40.7, 0, 0}, [](std::uint32_t i) { return i % 7 == 0; }), 42U);
  EXPECT_EQ(boxes.nearest({40.7, 0, 0}, [](std::uint32_t) { return false; }), std::nullopt);
}

// Boxes that come in order would make a list of a tree that is not balanced, and so would removing one half.
TEST(ObjectBoxes, StayBalanced) {
  constexpr std::uint32_t kNumbers = 4096;
  ObjectBoxes boxes;
  for (std::uint32_t i = 0; i < kNumbers; ++i) {
    const Eigen::Vector3d low(i, 0, 0);
    boxes.set(i, {low, low});
  }
  EXPECT_LE(boxes.height(), 1.45 * std::log2(kNumbers));
  for (std::uint32_t i = 0; i < kNumbers - 16; ++i) boxes.set(i, Box());
  EXPECT_LE(boxes.height(), 6);
}

TEST(BoxAround, ContainsTheBallThoughItsSidesAreRounded) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(2028, i, 99);
    const Ball ball{{random.unit(), random.log_uniform(-60, 60), -random.log_uniform(-60, 60)},
                    random.log_uniform(-60, 60)};
    const Box box = scene::detail::box_around(ball);
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class center = ball.center[axis], radius = ball.radius;
      EXPECT_LE(mpq_class(box.low[axis]), center - radius);
      EXPECT_GE(mpq_class(box.high[axis]), center + radius);
    }
  }
}

// Against the exact square of the distance. Boxes are drawn so that a side or a corner is about where the ball ends.
TEST(BoxesInReach, HaveEveryBoxThatABallTouches) {
  int touched = 0, missed = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Random random(2028, i, 101);
    const int scale = static_cast<int>(random.integer(-1000, 1000));
    Ball ball{{random.unit(), random.unit(), random.unit()}, random.unit()};
    Box box = draw_box(2031, i);
    mpq_class square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = box.high[axis] - box.low[axis];
      box.low[axis] =
          ball.center[axis] + ball.radius * (random.unit() < 0.5 ? 0.6 * random.unit() : 1.0 / std::sqrt(3));
      box.high[axis] = box.low[axis] + size;
      ball.center[axis] = std::ldexp(ball.center[axis], scale);
      box.low[axis] = std::ldexp(box.low[axis], scale), box.high[axis] = std::ldexp(box.high[axis], scale);
      const mpq_class gap = std::max<mpq_class>(
          {mpq_class(box.low[axis]) - ball.center[axis], mpq_class(ball.center[axis]) - box.high[axis], 0});
      square += gap * gap;
    }
    ball.radius = std::ldexp(ball.radius, scale);
    const mpq_class radius = ball.radius;
    const bool has = scene::detail::BoxesInReach(ball).has(box);
    if (square <= radius * radius) {
      EXPECT_TRUE(has) << i;
      ++touched;
    } else if (!has) {
      ++missed;
    }
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(missed, 100);
}

TEST(PosedBox, ContainsWhatIsPosed) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Random random(2028, i, 100);
    const Box box = draw_box(2030, i);
    Pose pose;
    for (double& entry : pose.rotation.reshaped()) entry = 2 * random.unit() - 1;
    for (double& entry : pose.translation) entry = 2 * random.unit() - 1;
    const Box all = scene::detail::posed(pose, box);
    Eigen::Vector3d point;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = random.unit();
      point[axis] = share < 0.3   ? box.low[axis]
                    : share < 0.6 ? box.high[axis]
                                  : std::clamp(box.low[axis] + random.unit() * (box.high[axis] - box.low[axis]),
                                               box.low[axis], box.high[axis]);
    }
    const Eigen::Vector3d here = scene::posed(pose, point);
    EXPECT_TRUE(meet({here, here}, all)) << i;
  }
}

}  // namespace
}  // namespace touchstone::scene_tests

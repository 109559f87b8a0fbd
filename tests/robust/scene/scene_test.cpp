// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantees of robust/scene/scene.h, against brute force over all faces by the exact path.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "robust/exact/exact.h"
#include "tests/robust/scene/brute_force.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::scene_tests {
namespace {

using scene::FaceId;
using scene::Scene;

// What the generators of scenes must not miss.
TEST(AdversarialScenes, HaveNegativeZeros) {
  contact_tests::NegativeZeros seen;
  bool turned = false, moved = false;
  for (const Kind kind : all_kinds()) {
    const auto objects = draw_objects(kind, 2026, 0);
    for (const scene::Faces& faces : objects)
      for (const Triangle& triangle : faces.triangles) seen.look_at(triangle);
    for (std::uint64_t index = 0; index < 50; ++index) {
      seen.look_at(draw_ball(all_polygons(objects), 2026, index));
      const Pose pose = draw_pose(objects, 2026, index);
      turned = turned || (pose.rotation.array() == 0 && pose.rotation.array().unaryExpr([](double x) {
                           return std::signbit(x);
                         })).any();
      moved = moved || (pose.translation.z() == 0 && std::signbit(pose.translation.z()));
    }
  }
  EXPECT_TRUE(seen.center);
  EXPECT_TRUE(seen.radius);
  EXPECT_TRUE(seen.vertex);
  EXPECT_TRUE(turned);
  EXPECT_TRUE(moved);
}

/// Calls f(subject, ball, words) for scenes of each kind.
template <class F>
void for_each_ball(std::uint64_t balls, const F& f) {
  for_each_query(draw_ball, balls,
                 [&](const Subject& subject, const Ball& ball, std::uint64_t, const std::string& what) {
                   f(subject, ball, what);
                 });
}

TEST(Scene, FindsExactlyTheFacesThatAreTouched) {
  for_each_ball(TOUCHSTONE_SAMPLES, [](const Subject& subject, const Ball& ball, const std::string& what) {
    const auto expected = subject.faces.touched_by_exact(ball);
    EXPECT_EQ(subject.built.touched(ball), expected) << what;
    EXPECT_EQ(subject.built.touches(ball), !expected.empty()) << what;
  });
}

// Floats cannot hold needles, which share leaves with triangles that they can.
TEST(Scene, AnswersAboutNeedlesInTheLeavesOfOtherTriangles) {
  scene::Faces faces;
  for (int i = 0; i < 16; ++i) {
    const Eigen::Vector3d corner(i % 4, i / 4, 0.125 * i);
    const Eigen::Vector3d across = i % 2 == 0 ? Eigen::Vector3d(0.5, 0x1p-34, 0) : Eigen::Vector3d(0.25, 0.75, 0);
    faces.triangles.push_back({corner, corner + Eigen::Vector3d(1, 0, 0), corner + across});
  }
  const Subject subject({faces}, "needles");
  for (int i = 0; i < 400; ++i) {
    const Ball ball{{i % 10 * 0.4375, i / 10 % 10 * 0.4375, i / 100 * 0.5}, 0.25 + 0.125 * (i % 3)};
    EXPECT_EQ(subject.built.touched(ball), subject.faces.touched_by_exact(ball)) << i;
    EXPECT_EQ(subject.built.nearest(ball), subject.faces.nearest_by_exact(ball)) << i;
  }
}

TEST(Scene, FindsTheNearestFaceAndTheLowestOfEquals) {
  for_each_ball(TOUCHSTONE_SAMPLES / 5, [](const Subject& subject, const Ball& ball, const std::string& what) {
    EXPECT_EQ(subject.built.nearest(ball), subject.faces.nearest_by_exact(ball)) << what;
  });
}

TEST(Scene, AnswersAboutChosenObjectsOnly) {
  for_each_ball(TOUCHSTONE_SAMPLES / 10, [](const Subject& subject, const Ball& ball, const std::string& what) {
    const Scene::Objects chosen(std::vector<std::uint32_t>{2, 0, 2});  // a set
    std::vector<FaceId> expected;
    for (const FaceId& id : subject.faces.touched_by_exact(ball))
      if (id.object != 1) expected.push_back(id);
    EXPECT_EQ(subject.built.touched(ball, chosen), expected) << what;
    EXPECT_EQ(subject.built.touches(ball, chosen), !expected.empty()) << what;
    EXPECT_NE(subject.built.nearest(ball, chosen)->face.object, 1U) << what;
    EXPECT_FALSE(subject.built.touches(ball, Scene::Objects(std::vector<std::uint32_t>{}))) << what;
  });
}

TEST(Scene, AnswersBatchesAsSingleQuestions) {
  for (const Kind kind : all_kinds()) {
    const Subject subject(draw_objects(kind, 2026, 7), name(kind));
    std::vector<Ball> balls;
    for (std::uint64_t i = 0; i < 300; ++i) balls.push_back(draw_ball(subject.faces.polygons(), 2026, i));
    const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
    subject.built.touches(balls, {touches.get(), balls.size()});
    const auto touched = subject.built.touched(balls);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      EXPECT_EQ(touches[i], subject.built.touches(balls[i])) << name(kind) << ", ball " << i;
      EXPECT_EQ(touched[i], subject.built.touched(balls[i])) << name(kind) << ", ball " << i;
    }
  }
}

TEST(Scene, AnswersInEveryFloatingPointEnvironmentAndLeavesItAsFound) {
  for_each_ball(TOUCHSTONE_SAMPLES / 20, [](const Subject& subject, const Ball& ball, const std::string& what) {
    const auto expected = subject.built.touched(ball);
    const auto expected_nearest = subject.built.nearest(ball);
    for (const contact_tests::State& state : contact_tests::kStates) {
      const contact_tests::Environment changed(state);
      const auto touched = subject.built.touched(ball);
      const auto nearest = subject.built.nearest(ball);
      const bool left = changed.left_as_found();
      EXPECT_EQ(touched, expected) << what << ", " << state;
      EXPECT_EQ(nearest, expected_nearest) << what << ", " << state;
      EXPECT_TRUE(left) << what << ", " << state;
    }
  });
}

// The corner at (1, 0, 0) is lifted to (1, 0, -1/4), out of the box of the vertices.
TEST(Scene, LooksForPolygonsWhereTheyAreLiftedTo) {
  Scene scene;
  scene.add("saddle", {{}, {Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}})}});
  EXPECT_TRUE(scene.touches({{1, 0, -0.25}, 0}));
  EXPECT_FALSE(scene.touches({{1, 0, 0}, 0}));
}

// Either side of a ridge is off its plane by so little that both distances are one double; the ridge, which they share
// as it was given, is lifted away from the centre on one side and towards it on the other.
TEST(Scene, TellsLiftedEdgesApartThatWereGivenInOnePlace) {
  const double off = 0x1p-60;
  const Polygon left({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, off}});
  const Polygon right({{1, 0, 0}, {2, 0, -1 + off}, {2, 1, -1}, {1, 1, 0}});
  const Ball center{{1.125, 0.25, 1}, 0};
  const exact::PreparedPolygon exact_left(left), exact_right(right);
  ASSERT_EQ(exact::answer(center, left).nearest, (Feature{Feature::Kind::Edge, 1}));
  ASSERT_EQ(exact::answer(center, right).nearest, (Feature{Feature::Kind::Edge, 3}));
  ASSERT_EQ(exact::answer(center, left).distance, exact::answer(center, right).distance);
  const int order = exact::compare_distances(center, exact_left, exact_right);
  ASSERT_NE(order, 0);
  const std::vector<Polygon> nearer_last = order > 0 ? std::vector{left, right} : std::vector{right, left};
  Scene scene;
  scene.add("ridge", {{}, nearer_last});
  EXPECT_EQ(scene.nearest(center)->face, (FaceId{0, 1}));
}

// The balls of no scene reach so far: the largest double is less than the distance.
TEST(Scene, FindsTheNearestFaceBeyondTheLargestDouble) {
  Scene scene;
  const double far = 0x1.8p1023;
  scene.add("far",
            {{{{far, 0, 0}, {far, 1, 0}, {far, 0, 1}}, {{far / 2, 0, 0}, {far / 2, 1, 0}, {far / 2, 0, 1}}}, {}});
  const auto found = scene.nearest({{-far, 0, 0}, 0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->face, (FaceId{0, 1}));
}

// The walk meets some of these faces, since differences of their coordinates overflow, and not the nearest.
TEST(Scene, FindsTheNearestOfFacesSomeOfWhichAreMet) {
  const double most = 0x1p1023, nearer = -0x1.a8279c73e2cp+1021;
  Scene one;
  one.add("one", {{{{-most, most, 0}, {-most, most, -1}, {-most, 0x1.0000000000001p+1023, 0}},
                   {{nearer, nearer, 0}, {nearer, nearer, -1}, {nearer, -0x1.a8279c73e2c01p+1021, 0}}},
                  {}});
  EXPECT_EQ(one.nearest({{most, most, 0}, 0})->face, (FaceId{0, 0}));

  const Triangle ahead{{-most, 0, 0}, {-most, 1, 0}, {-most, 0, 1}};
  const Triangle aside{{-most, 0x1p1010, 0}, {-most, 0x1p1010, 1}, {-most, 0x1p1011, 0}};
  Scene two;
  two.add("ahead", {{ahead, ahead}, {}});
  two.add("aside", {{aside}, {}});
  EXPECT_EQ(two.nearest({{most, 0, 0}, 0})->face, (FaceId{0, 0}));
}

TEST(Scene, IsEmptyAtFirst) {
  const Scene scene;
  EXPECT_FALSE(scene.touches({{0, 0, 0}, 1}));
  EXPECT_TRUE(scene.touched({{0, 0, 0}, 1}).empty());
  EXPECT_FALSE(scene.nearest({{0, 0, 0}, 1}));
}

TEST(Scene, NamesItsObjectsOnce) {
  Scene scene;
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(scene.add("a", {{triangle}, {}}), 0U);
  EXPECT_EQ(scene.add("b", {{triangle, triangle}, {}}), 1U);
  EXPECT_THROW(scene.add("a", {}), std::invalid_argument);
  EXPECT_EQ(scene.object_count(), 2U);
  EXPECT_EQ(scene.find("b"), 1U);
  EXPECT_EQ(scene.face_count(1), 2U);
  EXPECT_THROW((void)scene.find("c"), std::invalid_argument);
  EXPECT_THROW((void)scene.touches({{0, 0, 0}, 1}, std::vector<std::uint32_t>{2}), std::out_of_range);
}

}  // namespace
}  // namespace touchstone::scene_tests

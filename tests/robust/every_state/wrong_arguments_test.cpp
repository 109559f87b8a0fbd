// SPDX-License-Identifier: GPL-3.0-or-later
// The contract's "Wrong arguments": what is checked always, and what a debug build asserts.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/contact/fast.h"
#include "geometry/contact/fast_motion.h"
#include "geometry/contact/fast_triangle.h"
#include "geometry/contact/thesis.h"
#include "robust/exact/exact.h"
#include "robust/exact/motion.h"
#include "robust/filtered/filtered.h"
#include "robust/filtered/motion.h"
#include "robust/filtered/triangle_set.h"
#include "robust/mesh/merge.h"
#include "robust/mesh/weld.h"
#include "robust/scene/scene.h"

namespace touchstone::every_state_tests {
namespace {

const Triangle kTriangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
const Ball kBall{{1, 1, 0}, 1};

Polygon square() { return Polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}); }

scene::Scene scene_of_one() {
  scene::Scene scene;
  scene.add("one", {{kTriangle}, {}});
  return scene;
}

/// The message of an Error that the call throws.
template <class Error, class Call>
std::string message(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(WrongArguments, NumbersOfNoObjectAreNamed) {
  scene::Scene scene = scene_of_one();
  const std::string expected = "there is no object 99: the scene has 1";
  EXPECT_EQ(message<std::out_of_range>([&] { scene.set_pose(99, {}); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.pose(99); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.name(99); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.face_count(99); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.triangle_memory(99); }), expected);
  const scene::Scene::Objects some(std::vector<std::uint32_t>{0, 99});
  const Ball far{{99, 99, 99}, 1};
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touches(far, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touched(far, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.nearest(far, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.nearest_face(far.center, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touches(kBall, some); }), expected);  // object 0 is touched
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touched(std::vector<Ball>(), some); }), expected);
  const Motion near(kBall, far.center);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touches(near, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.touched(near, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.first_contact(near, some); }), expected);
  EXPECT_EQ(message<std::out_of_range>([&] { (void)scene.first_contact(std::vector<Motion>(), some); }), expected);
}

TEST(WrongArguments, SpansOfDifferentLengthsAreRefusedBeforeAnythingIsWritten) {
  const std::vector<Ball> balls(3, kBall);
  const std::vector<Triangle> triangles(3, kTriangle);
  const filtered::PreparedPolygon polygon(square());
  const scene::Scene scene = scene_of_one();
  std::array<bool, 2> touches{};
  EXPECT_EQ(message<std::invalid_argument>([&] { filtered::contact(balls, polygon, touches); }),
            "3 balls but 2 answers");
  EXPECT_EQ(message<std::invalid_argument>([&] { filtered::contact(kBall, triangles, touches); }),
            "3 triangles but 2 answers");
  EXPECT_EQ(message<std::invalid_argument>([&] { scene.touches(balls, touches); }), "3 balls but 2 answers");
  const std::vector<Motion> motions(3, Motion(kBall, kBall.center));
  EXPECT_EQ(message<std::invalid_argument>([&] { scene.touches(motions, touches); }), "3 motions but 2 answers");
  EXPECT_EQ(touches, (std::array<bool, 2>{}));
}

TEST(WrongArguments, TrianglesThatAreNoneAreNamedWhereTheyAreAdded) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto added = [](const Triangle& wrong) {
    scene::Scene scene;
    return message<Rejected>([&] { scene.add("part", {{kTriangle, wrong}, {}}); });
  };
  EXPECT_EQ(added({{0, 0, 0}, {nan, 0, 0}, {0, 4, 0}}),
            "object \"part\", face 1: the outer loop: vertex 1 is not finite");
  EXPECT_EQ(added({{0, 0, 0}, {1, 0, 0}, {0, 4, infinity}}),
            "object \"part\", face 1: the outer loop: vertex 2 is not finite");
  EXPECT_EQ(added({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}),
            "object \"part\", face 1: the outer loop: its Newell normal is zero");
}

TEST(WrongArguments, MeshesWithoutTheVerticesOfTheirFacesAreNamed) {
  const Mesh lacking{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_EQ(message<std::invalid_argument>([&] { (void)mesh::weld(lacking); }),
            "face 1 of the mesh has vertex 3; there are 3");
  EXPECT_EQ(message<std::invalid_argument>([&] { (void)mesh::merge_faces(lacking); }),
            "face 1 of the mesh has vertex 3; there are 3");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message<std::invalid_argument>([&] {
              (void)mesh::weld({{{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, {{0, 2, 1}}});
            }),
            "face 0 of the mesh has vertex 1, which is NaN");
}

#if !defined(NDEBUG)
TEST(WrongArgumentsDeathTest, BallsThatAreNoneAreAsserted) {
  const Polygon polygon = square();
  const fast::PreparedPolygon<> fast_polygon(polygon);
  const thesis::PreparedPolygon<> thesis_polygon(polygon);
  const exact::PreparedPolygon exact_polygon(polygon);
  const filtered::PreparedPolygon filtered_polygon(polygon);
  const scene::Scene scene = scene_of_one();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DEATH((void)scene.nearest_face({nan, 0, 0}), "find_fault");
  for (const Ball& wrong : {Ball{{nan, 0, 0}, 1}, Ball{{0, 0, 0}, -1}}) {
    EXPECT_DEATH((void)fast::contact(wrong, fast_polygon), "find_fault");
    EXPECT_DEATH((void)fast::contact(wrong, kTriangle), "find_fault");
    EXPECT_DEATH((void)thesis::contact(wrong, thesis_polygon), "find_fault");
    EXPECT_DEATH((void)exact::contact(wrong, exact_polygon), "find_fault");
    EXPECT_DEATH((void)filtered::contact(wrong, filtered_polygon), "find_fault");
    EXPECT_DEATH((void)filtered::answer(wrong, filtered_polygon), "find_fault");
    EXPECT_DEATH((void)filtered::contact(wrong, kTriangle), "find_fault");
    EXPECT_DEATH((void)scene.touches(wrong), "find_fault");
    EXPECT_DEATH((void)scene.nearest(wrong), "find_fault");
    EXPECT_DEATH((void)scene.touched(std::vector<Ball>(100, wrong)), "find_fault");
    EXPECT_DEATH((void)scene.first_contact(Motion{wrong, {0, 0, 0}}), "find_fault");
    EXPECT_DEATH((void)fast::contact(Motion{wrong, {0, 0, 0}}, fast_polygon), "find_fault");
    EXPECT_DEATH((void)fast::first_contact(Motion{wrong, {0, 0, 0}}, kTriangle), "find_fault");
    EXPECT_DEATH((void)exact::first_contact(Motion{wrong, {0, 0, 0}}, exact_polygon), "find_fault");
  }
}

// Of polygons, four balls at once are decided together, without single calls.
TEST(WrongArgumentsDeathTest, BatchesAreAssertedAsSingleCallsAre) {
  const filtered::PreparedPolygon polygon(square());
  const filtered::TriangleSet set(std::array{kTriangle});
  const scene::Scene scene = scene_of_one();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle wrong_triangle{{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}};
  const std::array triangles{kTriangle, kTriangle, kTriangle, kTriangle};
  const std::array wrong_triangles{kTriangle, wrong_triangle};
  const Motion motion{kBall, {0, 0, 0}};
  std::array<bool, 4> out{};
  const std::span<bool> four(out), two(four.first(2)), one(four.first(1));
  for (const Ball& wrong : {Ball{{nan, 0, 0}, 1}, Ball{{0, 0, 0}, -1}}) {
    const std::array balls{kBall, kBall, kBall, wrong};
    const Motion wrong_motion{wrong, {0, 0, 0}};
    const std::array motions{motion, motion, motion, wrong_motion};
    EXPECT_DEATH(filtered::contact(std::span(balls), polygon, four), "find_fault");
    EXPECT_DEATH(filtered::contact(wrong, std::span(triangles), four), "find_fault");
    EXPECT_DEATH(filtered::contact(std::span(motions), polygon, four), "find_fault");
    EXPECT_DEATH(filtered::contact(wrong_motion, std::span(triangles), four), "find_fault");
    EXPECT_DEATH(filtered::contact(wrong, set, one), "find_fault");
    EXPECT_DEATH((void)filtered::any_contact(wrong, set), "find_fault");
    EXPECT_DEATH((void)filtered::triangles_hit(wrong, set), "find_fault");
    EXPECT_DEATH(scene.touches(std::span(balls), four), "find_fault");
    EXPECT_DEATH((void)scene.touched(std::span(balls)), "find_fault");
    EXPECT_DEATH((void)scene.nearest(std::span(balls)), "find_fault");
    EXPECT_DEATH(scene.touches(std::span(motions), four), "find_fault");
    EXPECT_DEATH((void)scene.touched(std::span(motions)), "find_fault");
    EXPECT_DEATH((void)scene.first_contact(std::span(motions)), "find_fault");
  }
  EXPECT_DEATH(filtered::contact(kBall, std::span(wrong_triangles), two), "allFinite");
  EXPECT_DEATH(filtered::contact(motion, std::span(wrong_triangles), two), "allFinite");
}

TEST(WrongArgumentsDeathTest, TrianglesAndIndicesThatAreNoneAreAsserted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Triangle wrong{{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}};
  EXPECT_DEATH((void)filtered::contact(kBall, wrong), "allFinite");
  EXPECT_DEATH((void)filtered::closest({0, 0, 0}, wrong), "allFinite");
  EXPECT_DEATH((void)filtered::closest({0, nan, 0}, kTriangle), "allFinite");
  const Polygon polygon = square();
  EXPECT_DEATH((void)polygon.vertex(4), "vertex_count");
  EXPECT_DEATH((void)polygon.next(4), "vertex_count");
  EXPECT_DEATH((void)polygon.coordinates(3), "axis");
  EXPECT_DEATH((void)polygon.loop_end(1), "loop_count");
}
#endif

}  // namespace
}  // namespace touchstone::every_state_tests

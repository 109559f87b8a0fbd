// SPDX-License-Identifier: GPL-3.0-or-later
// What the library for C refuses, with which status and message, and what it leaves alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bindings/c/touchstone.h"
#include "robust/exact/validate.h"
#include "robust/scene/scene.h"
#include "robust/scene/solid.h"
#include "tests/bindings/c/in_c.h"
#include "tests/robust/support/environment.h"
#include "tests/robust/support/random_meshes.h"

namespace touchstone::c_tests {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Loop kSquare = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
const std::vector<double> kTriangle = {0, 0, 0, 4, 0, 0, 0, 4, 0};

/// The call, whose last argument is &error, fails with this status and this message, also without an error.
#define EXPECT_REFUSED(call, status_expected, message_expected) \
  do {                                                          \
    touchstone_error error{-1, "unwritten"};                    \
    EXPECT_EQ(call, status_expected) << #call;                  \
    EXPECT_EQ(error.status, status_expected) << #call;          \
    EXPECT_EQ(std::string(error.message), message_expected);    \
  } while (false)

touchstone_status create(const std::vector<Loop>& loops, touchstone_polygon** polygon, touchstone_error* error) {
  std::vector<double> vertices;
  std::vector<std::size_t> sizes;
  for (const Loop& loop : loops) {
    sizes.push_back(loop.size());
    for (const auto& vertex : loop) vertices.insert(vertices.end(), vertex.begin(), vertex.end());
  }
  return touchstone_polygon_create(vertices.data(), sizes.data(), sizes.size(), polygon, error);
}

touchstone_faces faces_of(const std::vector<double>& vertices) {
  touchstone_faces faces{};
  faces.triangles = {vertices.data(), vertices.size() / 3, nullptr, vertices.size() / 9};
  return faces;
}

/// The rejection of the loops in C++.
Rejection rejection_of(const std::vector<Loop>& loops) {
  try {
    return exact::validate(Polygon(loops[0], {loops.begin() + 1, loops.end()})).value();
  } catch (const Rejected& rejected) {
    return rejected.rejection();
  }
}

TEST(Refusals, OfPolygonsHaveTheCodeAndTheMessageOfCpp) {
  const std::pair<touchstone_status, std::vector<Loop>> wrong[] = {
      {TOUCHSTONE_NOT_FINITE, {{{0, 0, 0}, {1, kInfinity, 0}, {0, 1, 0}}}},
      {TOUCHSTONE_TOO_FEW_VERTICES, {{{0, 0, 0}, {1, 0, 0}}}},
      {TOUCHSTONE_TOO_FEW_VERTICES, {kSquare, {}}},
      {TOUCHSTONE_REPEATED_VERTEX, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}}},
      {TOUCHSTONE_ZERO_NORMAL, {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}},
      {TOUCHSTONE_LOOP_MEETS_ITSELF, {{{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {4, 5, 0}}}},
      {TOUCHSTONE_LOOPS_MEET, {kSquare, {{1, 1, 0}, {5, 1, 0}, {2, 2, 0}}}},
      {TOUCHSTONE_HOLE_OUTSIDE, {kSquare, {{5, 5, 0}, {6, 5, 0}, {5, 6, 0}}}},
  };
  for (const auto& [status, loops] : wrong) {
    const Rejection expected = rejection_of(loops);
    touchstone_polygon* polygon = reinterpret_cast<touchstone_polygon*>(&polygon);
    EXPECT_REFUSED(create(loops, &polygon, &error), status, expected.message);
    EXPECT_EQ(polygon, nullptr);
    EXPECT_STREQ(touchstone_status_name(status), std::string(to_string(expected.code)).c_str());
    EXPECT_EQ(create(loops, &polygon, nullptr), status);
  }
}

// The sum of the sizes is 0 in the arithmetic of size_t.
TEST(Refusals, OfLoopsThatNoMemoryHolds) {
  const std::size_t sizes[] = {4, std::numeric_limits<std::size_t>::max() - 3};
  touchstone_polygon* polygon = nullptr;
  EXPECT_REFUSED(touchstone_polygon_create(nullptr, sizes, 2, &polygon, &error), TOUCHSTONE_INVALID_ARGUMENT,
                 "the loops have more vertices than memory can hold");
}

TEST(Refusals, OfABatchNameTheFirstFaultyElement) {
  const auto polygon = polygon_in_c(Polygon(kSquare));
  const touchstone_ball good{{1, 1, 1}, 1};
  const touchstone_ball negative[] = {good, good, {{1, 1, 1}, -1}, {{kNan, 1, 1}, 1}};
  bool touches[4];
  EXPECT_REFUSED(touchstone_polygon_contact(polygon.get(), negative, 4, touches, &error), TOUCHSTONE_NEGATIVE_RADIUS,
                 "ball 2: the ball's radius is negative");
  EXPECT_REFUSED(touchstone_polygon_contact(polygon.get(), negative + 3, 1, touches, &error), TOUCHSTONE_NOT_FINITE,
                 "the ball's center is not finite");
  const touchstone_motion motions[] = {{good, {0, 0, 0}}, {good, {0, kInfinity, 0}}};
  touchstone_first_contact contacts[2];
  EXPECT_REFUSED(touchstone_polygon_first_contact(polygon.get(), motions, 2, contacts, &error), TOUCHSTONE_NOT_FINITE,
                 "motion 1: motion.to is not finite");
  touchstone_triangle triangles[3] = {};
  triangles[1].vertices[2][1] = kNan;
  touchstone_error said;
  EXPECT_EQ(touchstone_triangles_contact(&good, triangles, 3, touches, &said), TOUCHSTONE_NOT_FINITE);
  EXPECT_EQ(std::string(said.message).substr(0, 12), "triangle 1: ");
}

TEST(Refusals, OfNullNameTheArgument) {
  const auto polygon = polygon_in_c(Polygon(kSquare));
  const auto scene = scene_in_c();
  const touchstone_ball ball{{1, 1, 1}, 1};
  const touchstone_motion motion{ball, {2, 2, 2}};
  const touchstone_faces faces = faces_of(kTriangle);
  const touchstone_triangle triangle = in_c(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const std::size_t size = 4;
  const double numbers[12] = {};
  touchstone_polygon* made = nullptr;
  touchstone_solid* solid = nullptr;
  bool touches;
  std::int32_t relation;
  std::size_t count;
  std::uint32_t object;
  const auto refused = [](const std::string& name, const std::function<touchstone_status(touchstone_error*)>& call) {
    EXPECT_REFUSED(call(&error), TOUCHSTONE_INVALID_ARGUMENT, name + " is NULL");
    EXPECT_EQ(call(nullptr), TOUCHSTONE_INVALID_ARGUMENT);
  };
  using Error = touchstone_error*;
  refused("the array of vertices", [&](Error e) { return touchstone_polygon_create(nullptr, &size, 1, &made, e); });
  refused("the array of loop sizes", [&](Error e) { return touchstone_polygon_create(numbers, nullptr, 1, &made, e); });
  refused("the pointer to the new handle",
          [&](Error e) { return touchstone_polygon_create(numbers, &size, 1, nullptr, e); });
  refused("the polygon", [&](Error e) { return touchstone_polygon_complete(nullptr, e); });
  refused("the polygon", [&](Error e) { return touchstone_polygon_contact(nullptr, &ball, 1, &touches, e); });
  refused("the array of balls",
          [&](Error e) { return touchstone_polygon_contact(polygon.get(), nullptr, 1, &touches, e); });
  refused("the array of answers",
          [&](Error e) { return touchstone_polygon_contact(polygon.get(), &ball, 1, nullptr, e); });
  refused("the polygon", [&](Error e) { return touchstone_polygon_answer(nullptr, &ball, 0, nullptr, e); });
  refused("the array of edges",
          [&](Error e) { return touchstone_polygon_edges_hit(polygon.get(), &ball, nullptr, 1, &count, e); });
  refused("the pointer to the count",
          [&](Error e) { return touchstone_polygon_edges_hit(polygon.get(), &ball, nullptr, 0, nullptr, e); });
  refused("the array of answers",
          [&](Error e) { return touchstone_polygon_first_contact(polygon.get(), &motion, 1, nullptr, e); });
  refused("the array of balls",
          [&](Error e) { return touchstone_triangles_contact(nullptr, &triangle, 1, &touches, e); });
  refused("the array of triangles",
          [&](Error e) { return touchstone_triangles_contact(&ball, nullptr, 1, &touches, e); });
  refused("the array of points",
          [&](Error e) { return touchstone_triangles_closest(nullptr, &triangle, 1, nullptr, e); });
  refused("the array of answers",
          [&](Error e) { return touchstone_triangles_closest(numbers, &triangle, 1, nullptr, e); });
  refused("the array of motions",
          [&](Error e) { return touchstone_triangles_first_contact(nullptr, &triangle, 1, nullptr, e); });
  refused("the scene", [&](Error e) { return touchstone_scene_add(nullptr, "a", &faces, nullptr, &object, e); });
  refused("the name", [&](Error e) { return touchstone_scene_add(scene.get(), nullptr, &faces, nullptr, &object, e); });
  refused("the faces", [&](Error e) { return touchstone_scene_add(scene.get(), "a", nullptr, nullptr, &object, e); });
  refused("the pointer to the object",
          [&](Error e) { return touchstone_scene_add(scene.get(), "a", &faces, nullptr, nullptr, e); });
  touchstone_faces absent{};
  absent.polygon_count = 1;
  refused("the array of polygons",
          [&](Error e) { return touchstone_scene_add(scene.get(), "a", &absent, nullptr, &object, e); });
  const touchstone_polygon* no_polygon = nullptr;
  absent.polygons = &no_polygon;
  refused("a polygon of the array",
          [&](Error e) { return touchstone_scene_add(scene.get(), "a", &absent, nullptr, &object, e); });
  refused("the scene", [&](Error e) { return touchstone_scene_remove(nullptr, 0, e); });
  refused("the pose", [&](Error e) { return touchstone_scene_set_pose(scene.get(), 0, nullptr, e); });
  refused("the scene", [&](Error e) { return touchstone_scene_touches(nullptr, &ball, 1, nullptr, &touches, e); });
  refused("the array of answers",
          [&](Error e) { return touchstone_scene_nearest(scene.get(), &ball, 1, nullptr, nullptr, e); });
  const touchstone_scene_options one_object{nullptr, 1, 0};
  refused("the array of objects",
          [&](Error e) { return touchstone_scene_touches(scene.get(), &ball, 1, &one_object, &touches, e); });
  refused("the pointer to the new handle",
          [&](Error e) { return touchstone_scene_touched(scene.get(), &ball, 1, nullptr, nullptr, e); });
  refused("the mesh", [&](Error e) { return touchstone_solid_create(nullptr, &solid, e); });
  refused("the solid", [&](Error e) { return touchstone_solid_locate(nullptr, numbers, 1, 0, &relation, e); });
  refused("the solid", [&](Error e) { return touchstone_solid_touches(nullptr, &ball, 1, 0, &touches, e); });
  refused("the solid", [&](Error e) { return touchstone_solid_signed_distance(nullptr, numbers, 0, 0, nullptr, e); });
  EXPECT_EQ(touchstone_face_lists_offsets(nullptr), nullptr);
  EXPECT_EQ(touchstone_face_lists_faces(nullptr), nullptr);
  touchstone_polygon_free(nullptr);
  touchstone_scene_free(nullptr);
  touchstone_solid_free(nullptr);
  touchstone_face_lists_free(nullptr);
}

TEST(Refusals, DoNotConcernArraysOfNothing) {
  const auto polygon = polygon_in_c(Polygon(kSquare));
  const auto scene = scene_in_c();
  const touchstone_ball ball{{1, 1, 1}, 1};
  EXPECT_OK(touchstone_polygon_contact(polygon.get(), nullptr, 0, nullptr, &error));
  EXPECT_OK(touchstone_polygon_answer(polygon.get(), nullptr, 0, nullptr, &error));
  EXPECT_OK(touchstone_triangles_contact(&ball, nullptr, 0, nullptr, &error));
  EXPECT_OK(touchstone_scene_touches(scene.get(), nullptr, 0, nullptr, nullptr, &error));
  EXPECT_OK(touchstone_scene_nearest(scene.get(), nullptr, 0, nullptr, nullptr, &error));
  Owned<touchstone_face_lists> lists;
  EXPECT_OK(touchstone_scene_touched(scene.get(), nullptr, 0, nullptr, lists.out(), &error));
  EXPECT_EQ(touchstone_face_lists_offsets(lists.get())[0], 0U);
  std::size_t count = 0;
  EXPECT_OK(touchstone_polygon_edges_hit(polygon.get(), &ball, nullptr, 0, &count, &error));
}

TEST(Refusals, OfAScene) {
  const auto scene = scene_in_c();
  const touchstone_faces faces = faces_of(kTriangle);
  std::uint32_t object = 7;
  EXPECT_OK(touchstone_scene_add(scene.get(), "one", &faces, nullptr, &object, &error));
  touchstone_error said;
  EXPECT_EQ(touchstone_scene_add(scene.get(), "one", &faces, nullptr, &object, &said), TOUCHSTONE_INVALID_ARGUMENT);
  EXPECT_NE(std::string(said.message).find("\"one\""), std::string::npos) << said.message;

  std::vector<double> flat = kTriangle;
  flat[6] = 8, flat[7] = 0;
  const touchstone_faces degenerate = faces_of(flat);
  EXPECT_EQ(touchstone_scene_add(scene.get(), "flat", &degenerate, nullptr, &object, &said), TOUCHSTONE_ZERO_NORMAL);
  EXPECT_NE(std::string(said.message).find("object \"flat\""), std::string::npos) << said.message;
  touchstone_faces unknown = faces;
  unknown.degenerate = 2;
  EXPECT_REFUSED(touchstone_scene_add(scene.get(), "two", &unknown, nullptr, &object, &error),
                 TOUCHSTONE_INVALID_ARGUMENT, "no way to take degenerate triangles has the number 2");

  touchstone_pose pose = in_c(Pose{});
  pose.translation[1] = kNan;
  EXPECT_EQ(touchstone_scene_set_pose(scene.get(), 0, &pose, &said), TOUCHSTONE_NOT_FINITE);
  const touchstone_ball ball{{1, 1, 1}, 1};
  bool touches = false;
  EXPECT_OK(touchstone_scene_touches(scene.get(), &ball, 1, nullptr, &touches, &error));
  EXPECT_TRUE(touches);  // the object keeps its pose

  const std::uint32_t five = 5;
  const touchstone_scene_options absent{&five, 1, 0};
  for (const std::uint32_t threads : {0U, 1U}) {  // in and outside of an arena
    touchstone_scene_options options = absent;
    options.threads = threads;
    EXPECT_EQ(touchstone_scene_touches(scene.get(), &ball, 1, &options, &touches, &said), TOUCHSTONE_NO_SUCH_OBJECT);
    EXPECT_EQ(std::string(said.message).substr(0, 20), "there is no object 5");
  }
  EXPECT_OK(touchstone_scene_remove(scene.get(), 0, &error));
  EXPECT_REFUSED(touchstone_scene_remove(scene.get(), 0, &error), TOUCHSTONE_NO_SUCH_OBJECT, "object 0 was removed");

  touchstone_nearest_face nearest;
  EXPECT_OK(touchstone_scene_nearest(scene.get(), &ball, 1, nullptr, &nearest, &error));
  EXPECT_EQ(nearest.face.object, TOUCHSTONE_NONE);
  EXPECT_EQ(nearest.face.face, TOUCHSTONE_NONE);
  EXPECT_EQ(nearest.distance, kInfinity);
  EXPECT_EQ(nearest.depth, -kInfinity);
}

TEST(Refusals, OfAMeshNameTheFace) {
  touchstone_solid* solid = nullptr;
  const std::uint32_t corners[] = {0, 1, 2, 0, 3, 1};
  touchstone_mesh mesh{kTriangle.data(), 3, corners, 2};
  EXPECT_REFUSED(touchstone_solid_create(&mesh, &solid, &error), TOUCHSTONE_INVALID_ARGUMENT,
                 "face 1 has vertex 3 of a mesh with 3");
  mesh.corners = nullptr;
  EXPECT_REFUSED(touchstone_solid_create(&mesh, &solid, &error), TOUCHSTONE_INVALID_ARGUMENT,
                 "without corners, 2 triangles have three vertices each, not 3 in all");
  std::vector<double> two = kTriangle;
  two.insert(two.end(), kTriangle.begin(), kTriangle.end());
  two[10] = kNan;
  mesh = {two.data(), 6, nullptr, 2};
  touchstone_error said;
  EXPECT_EQ(touchstone_solid_create(&mesh, &solid, &said), TOUCHSTONE_NOT_FINITE);
  EXPECT_EQ(std::string(said.message).substr(0, 8), "face 1: ");
  two[10] = two[1];
  std::string expected;
  try {
    const std::vector<Triangle> triangles(2, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
    (void)scene::Solid(triangles);
  } catch (const scene::NotClosed& open) {
    expected = open.what();
  }
  EXPECT_REFUSED(touchstone_solid_create(&mesh, &solid, &error), TOUCHSTONE_NOT_CLOSED, expected);
  mesh = {};
  EXPECT_REFUSED(touchstone_solid_create(&mesh, &solid, &error), TOUCHSTONE_INVALID_ARGUMENT,
                 "object \"solid\" has no faces");
}

TEST(Refusals, OfPointsNameThePoint) {
  const Mesh cube = mesh_tests::cube();
  std::vector<double> vertices;
  for (const auto& face : cube.faces)
    for (const std::uint32_t vertex : face)
      vertices.insert(vertices.end(), cube.vertices[vertex].begin(), cube.vertices[vertex].end());
  const touchstone_mesh mesh{vertices.data(), vertices.size() / 3, nullptr, cube.faces.size()};
  Owned<touchstone_solid> solid;
  EXPECT_OK(touchstone_solid_create(&mesh, solid.out(), &error));
  const double points[] = {0, 0, 0, 1, 1, -kInfinity};
  std::int32_t locations[2];
  double distances[2];
  EXPECT_REFUSED(touchstone_solid_locate(solid.get(), points, 2, 0, locations, &error), TOUCHSTONE_NOT_FINITE,
                 "point 1: a coordinate of the point is not finite");
  EXPECT_REFUSED(touchstone_solid_signed_distance(solid.get(), points + 3, 1, 0, distances, &error),
                 TOUCHSTONE_NOT_FINITE, "a coordinate of the point is not finite");
}

TEST(Messages, AreCutAfterAWholeCharacter) {
  const auto scene = scene_in_c();
  std::vector<double> flat = kTriangle;
  flat[6] = 8, flat[7] = 0;
  const touchstone_faces degenerate = faces_of(flat);
  std::uint32_t object = 7;
  const auto message_about = [&](const std::string& name) {
    touchstone_error error;
    EXPECT_EQ(touchstone_scene_add(scene.get(), name.c_str(), &degenerate, nullptr, &object, &error),
              TOUCHSTONE_ZERO_NORMAL);
    return std::string(error.message);
  };
  for (std::size_t shift = 0; shift < 2; ++shift) {
    std::string name(shift, 'x');
    for (int i = 0; i < 400; ++i) name += "\u00e9";
    const std::string message = message_about(name);
    EXPECT_GE(message.size(), 506U);
    EXPECT_LE(message.size(), 507U);
    EXPECT_EQ(message.substr(message.size() - 5), "\u00e9...");
  }
  EXPECT_EQ(message_about(std::string(400, 'x')).find("..."), std::string::npos);
}

TEST(Statuses, HaveNames) {
  const std::pair<touchstone_status, const char*> names[] = {
      {TOUCHSTONE_OK, "ok"},
      {TOUCHSTONE_NEGATIVE_RADIUS, "negative-radius"},
      {TOUCHSTONE_NOT_CLOSED, "not-closed"},
      {TOUCHSTONE_INVALID_ARGUMENT, "invalid-argument"},
      {TOUCHSTONE_NO_SUCH_OBJECT, "no-such-object"},
      {TOUCHSTONE_OUT_OF_MEMORY, "out-of-memory"},
      {TOUCHSTONE_INTERNAL_ERROR, "internal-error"},
      {-1, "unknown"},
      {9, "unknown"},
      {1000, "unknown"},
  };
  for (const auto& [status, name] : names) EXPECT_STREQ(touchstone_status_name(status), name);
}

// In every rounding mode and flush-to-zero setting, with and without threads; none of them is changed.
TEST(FloatingPointState, ChangesNothingAndIsLeftAsFound) {
  const auto scene = scene_in_c();
  const touchstone_faces faces = faces_of(kTriangle);
  std::uint32_t object = 7;
  EXPECT_OK(touchstone_scene_add(scene.get(), "one", &faces, nullptr, &object, &error));
  std::vector<touchstone_ball> balls(100, {{1, 1, 0x1p-1060}, 0x1p-1060});
  balls[50].radius = -0x1p-1060;
  bool touches[100];
  for (const int mode : contact_tests::kModes)
    for (const unsigned flush : {contact_tests::Environment::kKeep, contact_tests::Environment::kBoth})
      for (const std::uint32_t threads : {0U, 1U, 2U}) {
        const touchstone_scene_options options{nullptr, 0, threads};
        std::fill_n(touches, 100, false);
        touchstone_status refused, answered;
        bool left_as_found;
        {
          const contact_tests::Environment environment(mode, flush);
          refused = touchstone_scene_touches(scene.get(), balls.data(), 100, &options, touches, nullptr);
          answered = touchstone_scene_touches(scene.get(), balls.data(), 50, &options, touches, nullptr);
          left_as_found = environment.left_as_found();
        }
        EXPECT_EQ(refused, TOUCHSTONE_NEGATIVE_RADIUS);
        EXPECT_EQ(answered, TOUCHSTONE_OK);
        EXPECT_EQ(std::count(touches, touches + 100, true), 50);
        EXPECT_TRUE(left_as_found);
      }
}

}  // namespace
}  // namespace touchstone::c_tests

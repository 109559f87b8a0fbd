// SPDX-License-Identifier: GPL-3.0-or-later
// Every answer of the library for C has the bits of the one in C++: on the corpus, and in batches.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "bindings/c/touchstone.h"
#include "experiments/cases/case.h"
#include "experiments/cases/workloads/random.h"
#include "robust/filtered/motion.h"
#include "robust/scene/scene.h"
#include "robust/scene/solid.h"
#include "tests/bindings/c/in_c.h"
#include "tests/robust/support/draw_point.h"
#include "tests/robust/support/random_meshes.h"

namespace touchstone::c_tests {
namespace {

/// The bits of all members in their order, which is the same in C and C++.
class Bits {
 public:
  template <class... Members>
  explicit Bits(const Members&... members) {
    (add(members), ...);
  }
  friend bool operator==(const Bits&, const Bits&) = default;

 private:
  void add(double number) { bits_.push_back(std::bit_cast<std::uint64_t>(number)); }
  void add(const Eigen::Vector3d& point) {
    for (const double coordinate : point) add(coordinate);
  }
  void add(const double (&point)[3]) {
    for (const double coordinate : point) add(coordinate);
  }
  template <class Integer>
  requires std::is_integral_v<Integer> || std::is_enum_v<Integer>
  void add(Integer number) { bits_.push_back(static_cast<std::uint64_t>(number)); }
  void add(const Bits& other) { bits_.insert(bits_.end(), other.bits_.begin(), other.bits_.end()); }

  std::vector<std::uint64_t> bits_;
};

Bits bits(const Feature& f) { return Bits(f.index, f.kind); }
Bits bits(const touchstone_feature& f) { return Bits(f.index, f.kind + f.reserved); }
Bits bits(const Answer& a) {
  return Bits(a.plane, a.plane_tangent, a.foot, a.relation, bits(a.nearest), a.point, a.distance, a.contact_normal,
              a.depth, a.off_plane);
}
Bits bits(const touchstone_answer& a) {
  return Bits(a.plane, a.plane_tangent, a.foot, a.relation, bits(a.nearest), a.point, a.distance, a.contact_normal,
              a.depth, a.off_plane);
}
Bits bits(const ClosestPoint& c) { return Bits(bits(c.feature), c.point, c.distance, c.contact_normal); }
Bits bits(const touchstone_closest_point& c) { return Bits(bits(c.feature), c.point, c.distance, c.contact_normal); }
Bits bits(const FirstContact& f) {
  return Bits(f.kind, f.momentary, f.time, bits(f.feature), f.point, f.contact_normal, f.depth);
}
Bits bits(const touchstone_first_contact& f) {
  return Bits(f.kind, f.momentary, f.time, bits(f.feature), f.point, f.contact_normal, f.depth);
}
Bits bits(const scene::FaceId& id) { return Bits(id.object, id.face); }
Bits bits(const touchstone_face_id& id) { return Bits(id.object, id.face); }
Bits bits(const scene::NearestFace& n) {
  return Bits(bits(n.face), bits(n.feature), n.point, n.distance, n.contact_normal, n.depth);
}
Bits bits(const touchstone_nearest_face& n) {
  return Bits(bits(n.face), bits(n.feature), n.point, n.distance, n.contact_normal, n.depth);
}
Bits bits(const scene::FirstFace& f) { return Bits(bits(f.face), bits(f.contact)); }
Bits bits(const touchstone_first_face& f) { return Bits(bits(f.face), bits(f.contact)); }
Bits bits(bool b) { return Bits(b); }

template <class C, class Cpp>
void expect_same(const C& in_c, const Cpp& in_cpp) {
  EXPECT_TRUE(bits(in_c) == bits(in_cpp));
}

template <class C, class Cpp>
void expect_all_same(const std::vector<C>& in_c, const std::vector<Cpp>& in_cpp) {
  ASSERT_EQ(in_c.size(), in_cpp.size());
  for (std::size_t i = 0; i < in_c.size(); ++i) expect_same(in_c[i], in_cpp[i]);
}

/// The lists as a list of lists.
std::vector<std::vector<touchstone_face_id>> unpacked(const Owned<touchstone_face_lists>& lists, std::size_t count) {
  const std::uint64_t* offsets = touchstone_face_lists_offsets(lists.get());
  const touchstone_face_id* faces = touchstone_face_lists_faces(lists.get());
  std::vector<std::vector<touchstone_face_id>> result;
  for (std::size_t i = 0; i < count; ++i) result.emplace_back(faces + offsets[i], faces + offsets[i + 1]);
  return result;
}

void expect_same_answers(const Motion& motion, const touchstone_polygon* polygon,
                         const filtered::PreparedPolygon& prepared) {
  const touchstone_ball ball = in_c(motion.ball);
  const touchstone_motion moving = in_c(motion);
  bool touches = false;
  EXPECT_OK(touchstone_polygon_contact(polygon, &ball, 1, &touches, &error));
  expect_same(touches, filtered::contact(motion.ball, prepared));
  touchstone_answer answer;
  EXPECT_OK(touchstone_polygon_answer(polygon, &ball, 1, &answer, &error));
  expect_same(answer, filtered::answer(motion.ball, prepared));
  std::uint64_t edges[2] = {77, 77};
  std::size_t count = 0;
  const auto hit = filtered::edges_hit(motion.ball, prepared);
  EXPECT_OK(touchstone_polygon_edges_hit(polygon, &ball, edges, 2, &count, &error));
  EXPECT_EQ(count, hit.size());
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(edges[i], i < hit.size() ? hit[i] : 77);
  touchstone_first_contact first;
  EXPECT_OK(touchstone_polygon_first_contact(polygon, &moving, 1, &first, &error));
  expect_same(first, filtered::first_contact(motion, prepared));
}

void expect_same_answers(const Motion& motion, const Triangle& of_cpp) {
  const touchstone_ball ball = in_c(motion.ball);
  const touchstone_motion moving = in_c(motion);
  const touchstone_triangle triangle = in_c(of_cpp);
  bool touches = false;
  EXPECT_OK(touchstone_triangles_contact(&ball, &triangle, 1, &touches, &error));
  expect_same(touches, filtered::contact(motion.ball, of_cpp));
  touchstone_closest_point closest;
  EXPECT_OK(touchstone_triangles_closest(ball.center, &triangle, 1, &closest, &error));
  expect_same(closest, filtered::closest(motion.ball.center, of_cpp));
  touchstone_first_contact first;
  EXPECT_OK(touchstone_triangles_first_contact(&moving, &triangle, 1, &first, &error));
  expect_same(first, filtered::first_contact(motion, of_cpp));
}

/// All questions to a scene, in one call each.
void expect_same_answers(const std::vector<Motion>& motions, const touchstone_scene* scene, const scene::Scene& of_cpp,
                         const touchstone_scene_options* options, const scene::Scene::Objects& objects) {
  const std::size_t count = motions.size();
  std::vector<Ball> balls;
  std::vector<touchstone_ball> balls_in_c;
  std::vector<touchstone_motion> motions_in_c;
  for (const Motion& motion : motions) {
    balls.push_back(motion.ball);
    balls_in_c.push_back(in_c(motion.ball)), motions_in_c.push_back(in_c(motion));
  }
  const auto expected = std::make_unique<bool[]>(count), touches = std::make_unique<bool[]>(count);

  of_cpp.touches(balls, std::span(expected.get(), count), objects);
  EXPECT_OK(touchstone_scene_touches(scene, balls_in_c.data(), count, options, touches.get(), &error));
  EXPECT_TRUE(std::equal(touches.get(), touches.get() + count, expected.get()));

  std::vector<touchstone_nearest_face> nearest(count);
  EXPECT_OK(touchstone_scene_nearest(scene, balls_in_c.data(), count, options, nearest.data(), &error));
  std::vector<touchstone_first_face> first(count);
  EXPECT_OK(touchstone_scene_first_contact(scene, motions_in_c.data(), count, options, first.data(), &error));
  const scene::FaceId none{TOUCHSTONE_NONE, TOUCHSTONE_NONE};
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto one = of_cpp.nearest(balls[i], objects))
      expect_same(nearest[i], *one);
    else
      expect_same(nearest[i].face, none);
    expect_same(first[i], of_cpp.first_contact(motions[i], objects).value_or(scene::FirstFace{none, {}}));
  }

  Owned<touchstone_face_lists> lists;
  EXPECT_OK(touchstone_scene_touched(scene, balls_in_c.data(), count, options, lists.out(), &error));
  const auto touched = unpacked(lists, count);
  for (std::size_t i = 0; i < count; ++i) expect_all_same(touched[i], of_cpp.touched(balls[i], objects));
}

std::vector<std::string> files_of_corpus() {
  const std::filesystem::path corpus = std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / "tests/corpus";
  std::vector<std::string> files;
  for (const auto& folder : {corpus, corpus / "floats"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The question; of a ball at a place, one that moves past it.
Motion motion_of(const cases::Shapes& shapes) {
  if (shapes.motion()) return *shapes.motion();
  const Ball& ball = shapes.ball();
  return {ball, shapes.polygon.vertex(0)};
}

TEST(EqualsCpp, OnTheCorpus) {
  int polygons = 0, triangles = 0;
  for (cases::LineReader reader(files_of_corpus()); const auto line = reader.next_case();) {
    const auto* shapes = line->read ? std::get_if<cases::Shapes>(&line->read->content) : nullptr;
    if (!shapes) continue;
    SCOPED_TRACE(line->place);
    const Motion motion = motion_of(*shapes);
    const Polygon& of_cpp = shapes->polygon;
    const filtered::PreparedPolygon prepared(of_cpp);
    const auto polygon = polygon_in_c(of_cpp);
    expect_same_answers(motion, polygon.get(), prepared);

    touchstone_faces faces{};
    const touchstone_polygon* const one = polygon.get();
    scene::Faces faces_of_cpp;
    if (of_cpp.vertex_count() == 3) {
      faces_of_cpp.triangles = {{of_cpp.vertex(0), of_cpp.vertex(1), of_cpp.vertex(2)}};
      faces.triangles = {faces_of_cpp.triangles[0].a.data(), 3, nullptr, 1};
      expect_same_answers(motion, faces_of_cpp.triangles[0]);
      ++triangles;
    } else {
      faces_of_cpp.polygons = {of_cpp};
      faces.polygons = &one, faces.polygon_count = 1;
    }
    scene::Scene scene_of_cpp;
    scene_of_cpp.add("object", faces_of_cpp);
    const Owned<touchstone_scene> scene = scene_in_c();
    std::uint32_t object = 7;
    EXPECT_OK(touchstone_scene_add(scene.get(), "object", &faces, nullptr, &object, &error));
    EXPECT_EQ(object, 0U);
    expect_same_answers(std::vector<Motion>{motion}, scene.get(), scene_of_cpp, nullptr, {});
    ++polygons;
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GT(polygons, 8000);
  EXPECT_GT(triangles, 2000);
}

/// Balls about the origin, on their ways.
std::vector<Motion> draw_motions(std::size_t count) {
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < count; ++i) {
    workloads::Random random(2026, i);
    const Eigen::Vector3d from = contact_tests::draw_point(random, 4);
    const Eigen::Vector3d to = contact_tests::draw_point(random, 4);
    const double radius = random.unit();
    motions.emplace_back(Ball{from, radius}, to);
  }
  return motions;
}

Pose tilted() {
  Pose pose;
  pose.rotation << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  pose.translation = {1, -2, 0.5};
  return pose;
}

Polygon frame() {
  return Polygon(Loop{{-2, -2, 0}, {2, -2, 0.25}, {2, 2, 0}, {-2, 2, 0.25}},
                 {Loop{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
}

TEST(EqualsCpp, InBatchesAboutAPolygon) {
  const std::vector<Motion> motions = draw_motions(300);
  const filtered::PreparedPolygon prepared(frame());
  const auto polygon = polygon_in_c(frame());
  EXPECT_OK(touchstone_polygon_complete(polygon.get(), &error));
  std::vector<touchstone_ball> balls;
  std::vector<touchstone_motion> ways;
  for (const Motion& motion : motions) balls.push_back(in_c(motion.ball)), ways.push_back(in_c(motion));
  const auto touches = std::make_unique<bool[]>(300);
  std::vector<touchstone_answer> answers(300);
  std::vector<touchstone_first_contact> first(300);
  EXPECT_OK(touchstone_polygon_contact(polygon.get(), balls.data(), 300, touches.get(), &error));
  EXPECT_OK(touchstone_polygon_answer(polygon.get(), balls.data(), 300, answers.data(), &error));
  EXPECT_OK(touchstone_polygon_first_contact(polygon.get(), ways.data(), 300, first.data(), &error));
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(touches[i], filtered::contact(motions[i].ball, prepared));
    expect_same(answers[i], filtered::answer(motions[i].ball, prepared));
    expect_same(first[i], filtered::first_contact(motions[i], prepared));
  }
}

TEST(EqualsCpp, AboutTrianglesThatMayBeDegenerate) {
  std::vector<Triangle> of_cpp;
  std::vector<touchstone_triangle> triangles;
  for (std::uint64_t i = 0; i < 200; ++i) {
    workloads::Random random(7, i);
    const Eigen::Vector3d a = contact_tests::draw_point(random, 2);
    const Eigen::Vector3d b = contact_tests::draw_point(random, 2);
    const Eigen::Vector3d c = contact_tests::draw_point(random, 2);
    of_cpp.push_back(i % 4 == 0 ? Triangle{a, b, b} : Triangle{a, b, c});
    triangles.push_back(in_c(of_cpp.back()));
  }
  for (const Motion& motion : draw_motions(20)) {
    for (const Triangle& triangle : of_cpp) expect_same_answers(motion, triangle);
    const touchstone_ball ball = in_c(motion.ball);
    const touchstone_motion moving = in_c(motion);
    std::vector<touchstone_first_contact> first(200);
    EXPECT_OK(touchstone_triangles_first_contact(&moving, triangles.data(), 200, first.data(), &error));
    const auto touches = std::make_unique<bool[]>(200);
    std::vector<touchstone_closest_point> closest(200);
    EXPECT_OK(touchstone_triangles_contact(&ball, triangles.data(), 200, touches.get(), &error));
    EXPECT_OK(touchstone_triangles_closest(ball.center, triangles.data(), 200, closest.data(), &error));
    for (std::size_t i = 0; i < 200; ++i) {
      EXPECT_EQ(touches[i], filtered::contact(motion.ball, of_cpp[i]));
      expect_same(closest[i], filtered::closest(motion.ball.center, of_cpp[i]));
      expect_same(first[i], filtered::first_contact(motion, of_cpp[i]));
    }
  }
}

/// A floor of shared vertices, the frame, and both under a pose, in C and in C++.
struct SceneInBoth {
  SceneInBoth() {
    const Mesh floor = mesh_tests::grid(6, 5, [](int i, int j) { return i != j; });
    scene::Faces faces;
    for (const auto& face : floor.faces) {
      faces.triangles.push_back({floor.vertices[face[0]], floor.vertices[face[1]], floor.vertices[face[2]]});
      corners.insert(corners.end(), face.begin(), face.end());
    }
    touchstone_faces both{};
    both.triangles = {floor.vertices[0].data(), floor.vertices.size(), corners.data(), floor.faces.size()};
    add("floor", both, faces, {});
    const auto polygon = polygon_in_c(frame());
    const touchstone_polygon* const polygons[] = {polygon.get()};
    both.polygons = polygons, both.polygon_count = 1;
    faces.polygons = {frame()};
    add("both", both, faces, tilted());
    both.triangles = {};
    faces.triangles.clear();
    add("frame", both, faces, {});
  }

  void add(const char* name, const touchstone_faces& faces, const scene::Faces& faces_of_cpp, const Pose& pose) {
    const touchstone_pose pose_in_c = in_c(pose);
    std::uint32_t object = 7;
    EXPECT_OK(touchstone_scene_add(scene.get(), name, &faces, &pose_in_c, &object, &error));
    EXPECT_EQ(object, of_cpp.add(name, faces_of_cpp, pose));
  }

  std::vector<std::uint32_t> corners;
  Owned<touchstone_scene> scene = scene_in_c();
  scene::Scene of_cpp;
};

TEST(EqualsCpp, InBatchesAboutAScene) {
  const SceneInBoth both;
  for (const std::size_t count : std::initializer_list<std::size_t>{1, 2, 300}) {
    const auto motions = draw_motions(count);
    expect_same_answers(motions, both.scene.get(), both.of_cpp, nullptr, {});
    for (const std::uint32_t threads : {0U, 1U, 3U, ~0U}) {
      const touchstone_scene_options all{nullptr, 0, threads};
      expect_same_answers(motions, both.scene.get(), both.of_cpp, &all, {});
    }
  }
}

TEST(EqualsCpp, AboutSomeObjects) {
  const SceneInBoth both;
  const std::uint32_t numbers[] = {2, 1};
  const touchstone_scene_options two{numbers, 2, 0}, none{numbers, 0, 0};
  for (const std::size_t count : std::initializer_list<std::size_t>{1, 100}) {
    expect_same_answers(draw_motions(count), both.scene.get(), both.of_cpp, &two,
                        std::vector<std::uint32_t>{numbers[0], numbers[1]});
    expect_same_answers(draw_motions(count), both.scene.get(), both.of_cpp, &none, std::vector<std::uint32_t>{});
  }
}

TEST(EqualsCpp, AboutObjectsThatAreMovedAndRemoved) {
  SceneInBoth both;
  touchstone_scene* const scene = both.scene.get();
  const touchstone_pose pose = in_c(tilted());
  EXPECT_OK(touchstone_scene_set_pose(scene, 0, &pose, &error));
  both.of_cpp.set_pose(0, tilted());
  expect_same_answers(draw_motions(100), scene, both.of_cpp, nullptr, {});
  EXPECT_OK(touchstone_scene_remove(scene, 1, &error));
  both.of_cpp.remove(1);
  expect_same_answers(draw_motions(100), scene, both.of_cpp, nullptr, {});
}

TEST(EqualsCpp, AboutAScenesSegments) {
  const double vertices[] = {0, 0, 0, 2, 0, 0, 2, 0, 0};
  touchstone_faces faces{};
  faces.triangles = {vertices, 3, nullptr, 1}, faces.degenerate = TOUCHSTONE_DEGENERATE_AS_SEGMENTS;
  const Owned<touchstone_scene> scene = scene_in_c();
  std::uint32_t object = 7;
  EXPECT_OK(touchstone_scene_add(scene.get(), "segment", &faces, nullptr, &object, &error));
  scene::Scene of_cpp;
  of_cpp.add("segment", {{{{0, 0, 0}, {2, 0, 0}, {2, 0, 0}}}, {}, Degenerate::AsSegments});
  expect_same_answers(draw_motions(50), scene.get(), of_cpp, nullptr, {});
}

// A cube, asked about the points of a lattice that has some inside, on its faces, edges and vertices, and outside.
TEST(EqualsCpp, AboutASolid) {
  const Mesh cube = mesh_tests::cube();
  std::vector<std::uint32_t> corners;
  for (const auto& face : cube.faces) corners.insert(corners.end(), face.begin(), face.end());
  const touchstone_mesh mesh{cube.vertices[0].data(), cube.vertices.size(), corners.data(), cube.faces.size()};
  Owned<touchstone_solid> solid;
  EXPECT_OK(touchstone_solid_create(&mesh, solid.out(), &error));
  const scene::Solid of_cpp(cube);
  std::vector<Eigen::Vector3d> points;
  std::vector<touchstone_ball> balls;
  for (int i = 0; i < 343; ++i) {
    points.emplace_back(Eigen::Vector3d(i % 7 - 1, i / 7 % 7 - 1, i / 49 - 1) / 4);
    balls.push_back(in_c(Ball{points.back(), 0.25}));
  }
  for (const std::size_t count : {std::size_t{1}, points.size()})
    for (const std::uint32_t threads : {0U, 1U, 2U}) {
      std::vector<std::int32_t> locations(count);
      std::vector<double> distances(count);
      const auto touches = std::make_unique<bool[]>(count);
      const double* from = points[points.size() - count].data();
      const touchstone_ball* of_these = &balls[points.size() - count];
      EXPECT_OK(touchstone_solid_locate(solid.get(), from, count, threads, locations.data(), &error));
      EXPECT_OK(touchstone_solid_signed_distance(solid.get(), from, count, threads, distances.data(), &error));
      EXPECT_OK(touchstone_solid_touches(solid.get(), of_these, count, threads, touches.get(), &error));
      for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3d& point = points[points.size() - count + i];
        EXPECT_EQ(locations[i], static_cast<int>(of_cpp.locate(point)));
        EXPECT_EQ(Bits(distances[i]), Bits(of_cpp.signed_distance(point)));
        EXPECT_EQ(touches[i], of_cpp.touches({point, 0.25}));
      }
    }
}

}  // namespace
}  // namespace touchstone::c_tests

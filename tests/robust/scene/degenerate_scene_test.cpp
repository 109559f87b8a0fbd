// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes whose triangles may be degenerate: every question against `exact`, face by face.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/motion.h"
#include "robust/scene/posing.h"
#include "robust/scene/scene.h"
#include "robust/scene/solid.h"
#include "tests/robust/scene/brute_force.h"

namespace touchstone::scene_tests {
namespace {

using Eigen::Vector3d;
using scene::FaceId;
using scene::Faces;
using scene::Scene;
using workloads::Random;

Vector3d lattice_point(Random& random, int size) {
  const auto coordinate = [&] { return static_cast<double>(random.integer(-size, size)); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

/// Half of them degenerate: three points of a line, of which several may be equal.
Triangle draw_triangle(Random& random, int size) {
  const Vector3d a = lattice_point(random, size), step = lattice_point(random, 2);
  if (random.coin()) return {a, a + step, a + lattice_point(random, 2)};
  return {a, a + static_cast<double>(random.integer(-2, 2)) * step,
          a + static_cast<double>(random.integer(-2, 2)) * step};
}

Faces draw_faces(Random& random, int size, double scale) {
  Faces faces{{}, {}, Degenerate::AsSegments};
  for (std::int64_t i = random.integer(1, 60); i > 0; --i) {
    const Triangle t = draw_triangle(random, size);
    faces.triangles.push_back({scale * t.a, scale * t.b, scale * t.c});
  }
  if (random.coin()) faces.polygons.push_back(Polygon({{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}, {0, scale, 0}}));
  return faces;
}

/// Turns of a quarter keep all on the lattice; others round vertices, so that lines bend.
Pose draw_turn_and_shift(Random& random) {
  Pose pose;
  if (random.integer(0, 2) == 0) return pose;
  const Vector3d axis = Vector3d::Unit(static_cast<int>(random.integer(0, 2)));
  const double angle = random.unit();
  pose.rotation = random.coin() ? Eigen::Matrix3d(Eigen::AngleAxisd(angle, axis).toRotationMatrix())
                                : Eigen::Matrix3d(Vector3d::Ones().asDiagonal());
  if (random.coin()) pose.rotation.col(0).swap(pose.rotation.col(1));
  pose.translation = lattice_point(random, 3);
  return pose;
}

/// The faces of a scene, by `exact`.
class Truth {
 public:
  void add(std::uint32_t object, const Faces& faces, const Pose& pose) {
    std::uint32_t number = 0;
    for (const Triangle& t : faces.triangles)
      add({object, number++}, exact::PreparedPolygon(scene::posed(pose, t, Degenerate::AsSegments)));
    for (const Polygon& p : faces.polygons) add({object, number++}, exact::PreparedPolygon(scene::posed(pose, p)));
  }

  template <class Query>
  [[nodiscard]] std::vector<FaceId> touched(const Query& query) const {
    std::vector<FaceId> touched;
    for (const auto& [id, face] : faces_)
      if (exact::contact(query, face)) touched.push_back(id);
    return touched;
  }
  [[nodiscard]] scene::NearestFace nearest(const Ball& ball) const {
    const auto* best = &faces_.front();
    for (const auto& face : faces_)
      if (exact::compare_distances(ball, face.second, best->second) < 0) best = &face;
    const Answer answer = exact::answer(ball, best->second);
    return {best->first, answer.nearest, answer.point, answer.distance, answer.contact_normal, answer.depth};
  }
  [[nodiscard]] std::vector<scene::FirstFace> in_order(const Motion& motion) const {
    std::vector<const std::pair<FaceId, exact::PreparedPolygon>*> order;
    for (const auto& face : faces_)
      if (exact::contact(motion, face.second)) order.push_back(&face);
    std::ranges::stable_sort(
        order, [&](const auto* a, const auto* b) { return exact::compare_times(motion, a->second, b->second) < 0; });
    std::vector<scene::FirstFace> faces;
    for (const auto* face : order) faces.push_back({face->first, exact::first_contact(motion, face->second)});
    return faces;
  }

 private:
  void add(FaceId id, exact::PreparedPolygon face) { faces_.emplace_back(id, std::move(face)); }

  std::vector<std::pair<FaceId, exact::PreparedPolygon>> faces_;
};

void expect_exact(const Scene& built, const Truth& truth, const Motion& motion) {
  const Ball& ball = motion.ball;
  const std::vector<FaceId> touched = truth.touched(ball), on_way = truth.touched(motion);
  EXPECT_EQ(built.touched(ball), touched);
  EXPECT_EQ(built.touches(ball), !touched.empty());
  EXPECT_EQ(built.touched(motion), on_way);
  EXPECT_EQ(built.touches(motion), !on_way.empty());
  EXPECT_EQ(built.nearest(ball), truth.nearest(ball));
  const std::vector<scene::FirstFace> order = truth.in_order(motion);
  EXPECT_EQ(built.touched_in_order(motion), order);
  const auto first = built.first_contact(motion);
  ASSERT_EQ(first.has_value(), !order.empty());
  if (!first) return;
  EXPECT_EQ(*first, order.front());
}

TEST(DegenerateScene, AnswersAreThoseOfExactWhereverItsObjectsAre) {
  for (std::uint64_t index = 0; index < TOUCHSTONE_SAMPLES / 40 + 4; ++index) {
    Random random(45, index);
    const int size = static_cast<int>(random.integer(1, 6));
    const double scale = std::ldexp(1.0, static_cast<int>(random.coin() ? 0 : random.integer(-1070, 900)));
    const std::vector<Faces> objects{draw_faces(random, size, scale), draw_faces(random, size, scale)};
    Scene built;
    for (const Faces& faces : objects) built.add(std::to_string(built.object_count()), faces);
    for (int move = 0; move < 2; ++move) {
      Truth truth;
      for (std::uint32_t object = 0; object < objects.size(); ++object) {
        Pose pose = move == 0 ? Pose() : draw_turn_and_shift(random);
        pose.translation *= scale;
        built.set_pose(object, pose);
        truth.add(object, objects[object], pose);
      }
      for (int i = 0; i < 8; ++i) {
        const Vector3d from = scale * lattice_point(random, size + 2), to = scale * lattice_point(random, size + 2);
        const double radius = scale * static_cast<double>(random.integer(0, 3));
        SCOPED_TRACE("sample " + std::to_string(index) + ", move " + std::to_string(move) + ", query " +
                     std::to_string(i));
        expect_exact(built, truth,
                     random.integer(0, 9) == 0 ? Motion({from, radius}, from) : Motion({from, radius}, to));
      }
    }
  }
}

// Two corners come so close that rounding makes them one: the object is then refused or not, as it was added.
TEST(DegenerateScene, APoseMayMakeTrianglesDegenerate) {
  const Triangle thin{{1, 0, 0}, {1, 0x1p-60, 0}, {2, 1, 0}};
  const Pose far{Eigen::Matrix3d::Identity(), {0, 16, 0}};
  Scene built;
  built.add("refuses", {{thin}, {}});
  built.add("accepts", {{thin}, {}, Degenerate::AsSegments});
  EXPECT_THROW(built.set_pose(0, far), Rejected);
  built.set_pose(1, far);
  const Scene::Objects accepts(std::vector<std::uint32_t>{1});
  EXPECT_TRUE(built.touches(Ball{{1.5, 16.5, 0}, 0}, accepts));
  EXPECT_FALSE(built.touches(Ball{{1.5, 16.5, 0x1p-1074}, 0}, accepts));
  EXPECT_EQ(built.nearest({{1.5, 16.5, 1}, 1}, accepts)->feature, (Feature{Feature::Kind::Edge, 1}));
}

TEST(DegenerateScene, IsRefusedUnlessTheFacesSaySo) {
  const Triangle point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  Scene built;
  EXPECT_THROW(built.add("point", {{point}, {}}), Rejected);
  EXPECT_EQ(built.add("point", {{point}, {}, Degenerate::AsSegments}), 0U);
  EXPECT_TRUE(built.touches(Ball{{1, 1, 3}, 2}));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(built.add("infinite", {{{{1, 1, infinity}, {1, 1, 1}, {1, 1, 1}}}, {}, Degenerate::AsSegments}),
               Rejected);
  EXPECT_THROW(scene::Solid(std::vector<Triangle>{point, point}), Rejected) << "solids take no segments";
}

}  // namespace
}  // namespace touchstone::scene_tests

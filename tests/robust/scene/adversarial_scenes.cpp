// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/scene/adversarial_scenes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/scene/posing.h"
#include "tests/robust/support/draw_point.h"
#include "tests/robust/support/rearranged.h"
#include "tests/robust/support/signed_zeros.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::draw_point;
using contact_tests::polygon_of;
using contact_tests::sign_zeros;
using workloads::Random;

double coordinate(Random& random) { return 2 * random.unit() - 1; }

/// Adds the triangle if it is one.
void add(scene::Faces& faces, const Triangle& t) {
  if (t.a == t.b || t.b == t.c || t.c == t.a) return;  // exact
  if (!exact::validate(polygon_of(t))) faces.triangles.push_back(t);
}

/// An L of unit size in a random plane through a point, its corners moved by up to `noise`.
void add_polygon(Random& random, scene::Faces& faces, const Eigen::Vector3d& at, double size, double noise) {
  const Eigen::Vector3d u = draw_point(random), v = draw_point(random);
  Loop loop;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 3.0}, {0.0, 3.0}})
    loop.emplace_back(at + size * (x * u + y * v + noise * draw_point(random)));
  const Polygon polygon(loop);
  if (!exact::validate(polygon)) faces.polygons.push_back(polygon);
}

void add_soup(Random& random, scene::Faces& faces, double size, const Eigen::Vector3d& at, int times) {
  for (int i = 0; i < 40 * times; ++i) {
    const Eigen::Vector3d near = at + size * draw_point(random);
    add(faces, {near, near + size / 4 * draw_point(random), near + size / 4 * draw_point(random)});
  }
  for (int i = 0; i < 4 * times; ++i) add_polygon(random, faces, at + size * draw_point(random), size / 4, 0x1p-52);
}

void add_lattice(Random& random, scene::Faces& faces, int side) {
  const auto at = [h = random.integer(-2, 2)](int i, int j) {
    return Eigen::Vector3d(i, j, static_cast<double>(i + 2 * j + h));
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      add(faces, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      add(faces, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
}

scene::Faces draw_faces(Random& random, Kind kind, int times) {
  scene::Faces faces;
  switch (kind) {
    case Kind::Soup: add_soup(random, faces, 1, {0, 0, 0}, times); break;
    case Kind::Coplanar: add_lattice(random, faces, 6 * times); break;
    case Kind::Needles:
      for (int i = 0; i < 60 * times; ++i) {
        const Eigen::Vector3d end = draw_point(random);
        add(faces, {{0, 0, 0}, end, end + 0x1p-30 * draw_point(random)});
      }
      break;
    case Kind::Duplicates: {
      scene::Faces few;
      add_soup(random, few, 1, {0, 0, 0}, 1);
      for (int i = 0; i < 60 * times; ++i) faces.triangles.push_back(few.triangles[static_cast<std::size_t>(i) % 3]);
      for (int i = 0; i < 4; ++i) faces.polygons.push_back(few.polygons.front());
      break;
    }
    case Kind::MixedSizes:
      for (int i = 0; i < 60 * times; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random.integer(-60, 60)));
        const Eigen::Vector3d near = size * draw_point(random);
        add(faces, {near, near + size * draw_point(random), near + size * draw_point(random)});
      }
      break;
    case Kind::HugeNumbers: add_soup(random, faces, 0x1p1019, {0, 0, 0}, times); break;
    case Kind::TinyNumbers: add_soup(random, faces, random.coin() ? 0x1p-1000 : 0x1p-1066, {0, 0, 0}, times); break;
    case Kind::FarAway: add_soup(random, faces, 1, 0x1p40 * draw_point(random), times); break;
    case Kind::OffPlane:
      // Few, so that no neighbour's box makes up for what a box lacks.
      while (faces.polygons.size() < 2)
        add_polygon(random, faces, 4 * draw_point(random), 0.3,
                    std::ldexp(1.0, -static_cast<int>(random.integer(1, 50))));
      break;
  }
  return faces;
}

}  // namespace

const std::vector<Kind>& all_kinds() {
  static const std::vector<Kind> kinds{Kind::Soup,        Kind::Coplanar,   Kind::Needles,
                                       Kind::Duplicates,  Kind::MixedSizes, Kind::HugeNumbers,
                                       Kind::TinyNumbers, Kind::FarAway,    Kind::OffPlane};
  return kinds;
}

std::string name(Kind kind) {
  constexpr const char* names[] = {"soup",         "coplanar",     "needles",  "duplicates", "mixed sizes",
                                   "huge numbers", "tiny numbers", "far away", "off plane"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<scene::Faces> draw_objects(Kind kind, std::uint64_t seed, std::uint64_t index, int times) {
  std::vector<scene::Faces> objects;
  for (std::uint64_t object = 0; object < 3; ++object) {
    Random random(seed, 3 * index + object, 70 + static_cast<std::uint64_t>(kind));
    scene::Faces faces = draw_faces(random, kind, times);
    for (Triangle& triangle : faces.triangles) sign_zeros(triangle, random);
    for (Polygon& polygon : faces.polygons) sign_zeros(polygon, random);
    objects.push_back(std::move(faces));
  }
  return objects;
}

std::vector<Polygon> all_polygons(const std::vector<scene::Faces>& objects) {
  std::vector<Polygon> all;
  for (const scene::Faces& faces : objects) {
    for (const Triangle& triangle : faces.triangles) all.push_back(polygon_of(triangle));
    all.insert(all.end(), faces.polygons.begin(), faces.polygons.end());
  }
  return all;
}

Motion draw_motion(const std::vector<Polygon>& all, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, 67);
  const Ball ball = draw_ball(all, seed, index);
  const Polygon& face = all[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(all.size()) - 1))];
  const Eigen::Vector3d edge = face.vertex(1) - face.vertex(0);
  Eigen::Vector3d way;
  switch (random.integer(0, 3)) {
    case 0: way = edge; break;
    case 1: way = edge.cwiseAbs().maxCoeff() * Eigen::Vector3d::Unit(random.integer(0, 2)); break;
    case 2: way = face.vertex(2) - ball.center; break;
    default: way = edge.cwiseAbs().maxCoeff() * draw_point(random);
  }
  if (random.coin()) way *= std::ldexp(1.0, static_cast<int>(random.integer(-40, 2)));
  Motion motion(ball, ball.center);
  switch (random.integer(0, 4)) {
    case 0: break;
    case 1: motion.to += way; break;
    case 2: motion.ball.center -= way; break;
    case 3: motion.ball.center -= way / 2, motion.to += way / 2; break;
    default: motion.ball.center -= way, motion.to += way;
  }
  if (find_fault(motion)) return {ball, ball.center};
  sign_zeros(motion.to, random);
  return motion;
}

Ball draw_ball(const std::vector<Polygon>& all, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, 69);
  const auto pick = [&random](const auto& list) -> const auto& {
    return list[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(list.size()) - 1))];
  };
  const Polygon &near = pick(all), &other = pick(all);
  // At a vertex, between two of one face or of two faces, or beside a face.
  const double share = random.coin() ? 0 : random.unit() / 2;
  Eigen::Vector3d center = (1 - share) * near.vertex(0) + share * (random.coin() ? near : other).vertex(1);
  if (random.coin()) center += (near.vertex(1) - near.vertex(0)).cwiseAbs().maxCoeff() * draw_point(random);
  const double distance = exact::answer({center, 0}, random.coin() ? near : other).distance;
  Ball ball{center, 0};
  switch (random.integer(0, 3)) {
    case 0: break;
    case 1: ball.radius = distance * random.unit(); break;
    default: ball.radius = std::max(0.0, workloads::move_by_doubles(distance, random.integer(-1, 1)));
  }
  sign_zeros(ball, random);
  return ball;
}

scene::Faces posed(const Pose& pose, const scene::Faces& model) {
  scene::Faces result;
  for (const Triangle& triangle : model.triangles) result.triangles.push_back(scene::posed(pose, triangle));
  for (const Polygon& polygon : model.polygons) result.polygons.push_back(scene::posed(pose, polygon));
  return result;
}

Pose draw_pose(const std::vector<scene::Faces>& objects, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, 68);
  double largest = 0;
  for (const scene::Faces& faces : objects) {
    for (const Triangle& t : faces.triangles) largest = std::max(largest, t.a.cwiseAbs().maxCoeff());
    for (const Polygon& p : faces.polygons) largest = std::max(largest, p.vertex(0).cwiseAbs().maxCoeff());
  }
  Pose pose;
  switch (random.integer(0, 5)) {
    case 0: sign_zeros(pose, random); return pose;
    case 1: break;
    case 2: {  // a quarter turn and a reflection
      const auto axis = static_cast<int>(random.integer(0, 2));
      pose.rotation.row(axis).swap(pose.rotation.row((axis + 1) % 3));
      break;
    }
    case 3:
      pose.rotation = Eigen::AngleAxisd(std::atan(1.0), Eigen::Vector3d::Unit(random.integer(0, 2))).toRotationMatrix();
      break;
    case 4:
      for (int row = 0; row < 3; ++row) pose.rotation.row(row) = draw_point(random) / 2;
      break;
    default: {
      const Eigen::Quaterniond turn{coordinate(random), coordinate(random), coordinate(random), coordinate(random)};
      pose.rotation = turn.normalized().toRotationMatrix();
      if (random.coin()) pose.rotation = (0.75 * pose.rotation).cast<float>().cast<double>();
    }
  }
  if (random.coin()) {
    const Eigen::Vector3d direction = draw_point(random);
    pose.translation = std::ldexp(largest, static_cast<int>(random.integer(-40, -2))) * direction;
  }
  sign_zeros(pose, random);
  return pose;
}

}  // namespace touchstone::scene_tests

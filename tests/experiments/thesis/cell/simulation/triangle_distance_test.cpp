// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of triangles: the two bounds enclose what another library computes exactly.
#include "experiments/thesis/cell/simulation/triangle_distance.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d point(workloads::Random& random, double size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}
Triangle triangle(workloads::Random& random, const Eigen::Vector3d& at, double size) {
  return {at + point(random, size), at + point(random, size), at + point(random, size)};
}

double reference(const Triangle& s, const Triangle& t) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto at = [](const Eigen::Vector3d& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  const Kernel::Triangle_3 one(at(s.a), at(s.b), at(s.c)), other(at(t.a), at(t.b), at(t.c));
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(one, other)));
}

TEST(TriangleDistance, EnclosesTheExactDistance) {
  workloads::Random random(1, 0);
  int touching = 0;
  for (int i = 0; i < 400; ++i) {
    const Triangle s = triangle(random, {0, 0, 0}, 10),
                   t = triangle(random, point(random, 15), between(random, 0.1, 20));
    const double exact = reference(s, t);
    const DistanceBounds bounds = distance(s, t);
    EXPECT_LE(bounds.lower, exact + 1e-14);
    EXPECT_GE(bounds.upper, exact - 1e-12);
    EXPECT_LE(bounds.upper - bounds.lower, 1e-11);
    if (exact == 0) ++touching;
  }
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 390);
}

TEST(TriangleDistance, OfPointsSegmentsAndParallelFaces) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, above{{0, 0, 3}, {4, 0, 3}, {0, 4, 3}};
  const auto is = [](const DistanceBounds& bounds, double distance) {
    EXPECT_NEAR(bounds.lower, distance, 1e-12);
    EXPECT_NEAR(bounds.upper, distance, 1e-12);
  };
  is(distance(flat, above), 3);
  is(distance(flat, flat), 0);
  const Eigen::Vector3d high{1, 1, 2}, far{-3, 0, 4};
  is(distance(flat, {high, high, high}), 2);
  is(distance({far, far, far}, flat), 5);
  is(distance({{-1, -2, 0}, {-1, -2, 0}, {9, -2, 0}}, flat), 2);
  is(distance({{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}, flat), 0);  // a needle through it
  is(distance({high, high, high}, {far, far, far}), (high - far).norm());
}

// Vertex to face, edge to edge, face to face, and beside each other in one plane: rounding turns the line through the
// two nearest points, which no longer parts them.
TEST(TriangleDistance, ANearMissIsNoContact) {
  workloads::Random random(3, 0);
  int near = 0;
  for (int i = 0; i < 200; ++i) {
    const Triangle s = triangle(random, point(random, 500), 300);
    const Eigen::Vector3d n = (s.b - s.a).cross(s.c - s.a).normalized();
    Triangle t = triangle(random, (s.a + s.b + s.c) / 3, 300);
    Eigen::Vector3d way = point(random, 1).normalized();
    if (i % 4 == 0) t = s, way = n;
    if (i % 4 == 1) t = {s.a, s.b, s.a + s.b - s.c}, way = (s.b - s.a).cross(n).normalized();
    const auto shifted = [&](double by) { return Triangle{t.a + by * way, t.b + by * way, t.c + by * way}; };
    double touching = 0, apart = 4000;
    if (reference(s, t) > 1e-9) continue;
    while (apart - touching > 1e-9) {
      const double middle = (touching + apart) / 2;
      (reference(s, shifted(middle)) > 0 ? apart : touching) = middle;
    }
    const Triangle beside = shifted(apart + 1e-8);
    const double exact = reference(s, beside);
    if (exact < 1e-10) continue;
    ++near;
    const DistanceBounds bounds = distance(s, beside);
    EXPECT_GT(bounds.lower, 0) << "seed 3, pair " << i << ", which are " << exact << " apart";
    EXPECT_LE(bounds.lower, exact);
  }
  EXPECT_GT(near, 100);
}

// With two hierarchies and a pose, as with every pair; a cutoff hides only what is further.
TEST(TriangleDistance, OfTreesIsTheLeastOfAllPairs) {
  workloads::Random random(2, 0);
  for (int i = 0; i < 20; ++i) {
    std::vector<NamedTriangle> moving, still;
    for (int k = 0; k < 40; ++k) moving.push_back({triangle(random, point(random, 20), 4), 0});
    for (int k = 0; k < 60; ++k)
      still.push_back({triangle(random, point(random, 20) + Eigen::Vector3d(30, 0, 0), 4), 0});
    const Eigen::AngleAxisd turn(between(random, 0, 3), point(random, 1).normalized());
    const Pose pose{turn.toRotationMatrix(), point(random, 10)};
    DistanceBounds least{kInfinity, kInfinity};
    for (const auto& m : moving)
      for (const auto& s : still) {
        const auto here = distance(Triangle{pose * m.triangle.a, pose * m.triangle.b, pose * m.triangle.c}, s.triangle);
        least = {std::min(least.lower, here.lower), std::min(least.upper, here.upper)};
      }
    const TriangleTree one(moving), other(still);
    const DistanceBounds bounds = distance(one, pose, other, kInfinity);
    EXPECT_NEAR(bounds.upper, least.upper, 1e-10);
    EXPECT_LE(bounds.lower, least.upper);
    EXPECT_NEAR(bounds.lower, least.lower, 1e-10);
    EXPECT_EQ(distance(one, pose, other, least.lower / 2).lower, least.lower / 2);
    EXPECT_NEAR(distance(one, pose, other, least.upper + 1).upper, least.upper, 1e-10);
  }
}

}  // namespace
}  // namespace touchstone::cell

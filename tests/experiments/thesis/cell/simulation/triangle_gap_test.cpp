// SPDX-License-Identifier: GPL-3.0-or-later
// What is certainly apart is apart: whatever points of two triangles are taken.
#include "experiments/thesis/cell/simulation/triangle_gap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/thesis/cell/simulation/triangle_tree.h"
#include "tests/experiments/thesis/cell/simulation/cells.h"

namespace touchstone::cell_simulation_tests {
namespace {

Triangle random_triangle(workloads::Random& random, double size) {
  const auto point = [&]() -> Eigen::Vector3d {
    return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
  };
  const Eigen::Vector3d at = 3 * point();
  return {at + point(), at + point(), at + point()};
}

/// The least distance of points on a grid over both: never less than the triangles'.
double sampled_distance(const Triangle& a, const Triangle& b) {
  static constexpr int kPoints = 8;
  const auto points = [](const Triangle& t) {
    std::vector<Eigen::Vector3d> all;
    for (int i = 0; i <= kPoints; ++i)
      for (int j = 0; i + j <= kPoints; ++j) all.push_back(t.a + i * (t.b - t.a) / kPoints + j * (t.c - t.a) / kPoints);
    return all;
  };
  double least = 1e300;
  const auto others = points(b);
  for (const Eigen::Vector3d& p : points(a))
    for (const Eigen::Vector3d& q : others) least = std::min(least, (p - q).norm());
  return least;
}

TEST(TriangleGap, NeverClaimsMoreThanThereIs) {
  for (std::uint64_t n = 0; n < 40; ++n) {
    workloads::Random random(11, n);
    const double size = n % 2 == 0 ? 0.01 : 100;
    const Triangle a = random_triangle(random, size), b = random_triangle(random, size);
    const double distance = sampled_distance(a, b);
    EXPECT_FALSE(cell::further_apart(a, b, distance)) << n;
    EXPECT_FALSE(cell::further_apart(a, a, 0)) << n;
    // And it claims enough: apart by the directions that it tries.
    if (distance > 2 * size) {
      EXPECT_TRUE(cell::further_apart(a, b, distance / 4)) << n;
    }
  }
}

TEST(TriangleGap, KnowsTouchingFromApart) {
  const Triangle floor{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto above = [](double height) { return Triangle{{0, 0, height}, {1, 0, height + 1}, {0, 1, height + 1}}; };
  EXPECT_FALSE(cell::further_apart(floor, above(0), 0));
  EXPECT_TRUE(cell::further_apart(floor, above(0.5), 0));
  EXPECT_TRUE(cell::further_apart(floor, above(0.5), 0.49));
  EXPECT_FALSE(cell::further_apart(floor, above(0.5), 0.5));
  const Triangle beside{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}};  // in the same plane
  EXPECT_TRUE(cell::further_apart(floor, beside, 0.99));
  EXPECT_FALSE(cell::further_apart(floor, beside, 1));
}

TEST(TriangleTree, FindsWhatMeetsABoxAndNothingElse) {
  workloads::Random random(12, 0);
  std::vector<cell::NamedTriangle> triangles;
  for (std::uint32_t i = 0; i < 100; ++i) triangles.push_back({random_triangle(random, 1), i});
  const cell::TriangleTree tree(triangles);
  for (int n = 0; n < 50; ++n) {
    const Box around = box(random_triangle(random, 1));
    std::vector<std::uint32_t> expected, found;
    for (const auto& [triangle, owner] : triangles) {
      const Box its = box(triangle);
      if ((its.low.array() <= around.high.array()).all() && (around.low.array() <= its.high.array()).all())
        expected.push_back(owner);
    }
    EXPECT_EQ(tree.find(around,
                        [&](const cell::NamedTriangle& each) {
                          found.push_back(each.owner);
                          return false;
                        }),
              nullptr);
    std::ranges::sort(found);
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace touchstone::cell_simulation_tests

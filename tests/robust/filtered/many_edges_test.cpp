// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that wind through the plane: groups of edges in the hierarchy have many ends, some level with the foot.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "experiments/cases/workloads/outline.h"
#include "robust/exact/exact.h"
#include "tests/robust/filtered/wrong_answers.h"
#include "tests/robust/support/printing.h"

namespace touchstone::filtered_tests {
namespace {

using workloads::Family;
using workloads::Random;

Loop in_plane(const workloads::LatticeLoop& loop, double z) {
  Loop result;
  for (const auto& p : loop) result.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y), z);
  return result;
}

Polygon in_plane(const workloads::Outline& outline, double z = 0) {
  std::vector<Loop> holes;
  for (const auto& hole : outline.holes) holes.push_back(in_plane(hole, z));
  return Polygon(in_plane(outline.outer, z), holes);
}

/// Feet at the height of a vertex, or anywhere about the outline, beside it and on it; small radii and large ones.
Ball draw_ball(Random& random, const Polygon& polygon) {
  const auto vertex = [&] {
    const auto last = static_cast<std::int64_t>(polygon.vertex_count()) - 1;
    return Eigen::Vector3d(polygon.vertex(static_cast<std::size_t>(random.integer(0, last))));
  };
  const Eigen::Vector3d a = vertex(), b = vertex();
  const double share = random.coin() ? 1 : random.unit(), height = random.coin() ? 0 : random.unit() * 1000;
  const Eigen::Vector3d center(share * a.x() + (1 - share) * b.x(), random.coin() ? a.y() : b.y(), height);
  return {center, random.coin() ? height : random.unit() * 0x1p-6 * (a - b).norm()};
}

TEST(FilteredManyEdges, AreAnsweredAsByExact) {
  for (const Family family : {Family::Spiral, Family::RandomSimple, Family::Koch, Family::Star, Family::Comb})
    for (const std::size_t vertices : {48U, 192U, 700U})
      for (const std::uint64_t index : {0U, 1U, 2U}) {
        workloads::Workload workload;
        workload.family = family, workload.vertices = vertices, workload.holes = index;
        const Polygon polygon = in_plane(workloads::draw_outline(workload, 2026, index));
        const filtered::PreparedPolygon prepared(polygon);
        const exact::PreparedPolygon truth(polygon);
        for (std::uint64_t i = 0; i < 20 + TOUCHSTONE_SAMPLES / 5; ++i) {
          Random random(2026, 1000 * index + i, 99);
          const Ball ball = draw_ball(random, polygon);
          const std::string what = std::string(to_string(family)) + " of " + std::to_string(vertices) +
                                   " vertices, sample " + std::to_string(index) + ", ball " + std::to_string(i);
          EXPECT_EQ(filtered::foot(ball, prepared), exact::foot(ball, truth)) << what;
          EXPECT_EQ(filtered::relation(ball, prepared), exact::relation(ball, truth)) << what;
          EXPECT_EQ(filtered::edges_hit(ball, prepared), exact::edges_hit(ball, truth)) << what;
          if (i >= 10) continue;  // exact takes its time
          EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "") << what;
        }
      }
}

// Balls with feet and radii of their own: the lanes of a batch do not know each other.
TEST(FilteredManyEdges, AreAnsweredInBatchesAsOneByOne) {
  for (const Family family : {Family::Spiral, Family::Koch, Family::Star}) {
    workloads::Workload workload;
    workload.family = family, workload.vertices = 192;
    const Polygon polygon = in_plane(workloads::draw_outline(workload, 2026, 0));
    const filtered::PreparedPolygon prepared(polygon);
    std::vector<Ball> balls;
    for (std::uint64_t i = 0; i < 403; ++i) {
      Random random(2026, i, 97);
      balls.push_back(draw_ball(random, polygon));
    }
    const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
    filtered::contact(balls, prepared, {touches.get(), balls.size()});
    for (std::size_t i = 0; i < balls.size(); ++i)
      EXPECT_EQ(touches[i], filtered::contact(balls[i], prepared)) << to_string(family) << ", ball " << i;
  }
}

// Small balls whose radius is the nearest double to their distance, which doubles cannot decide.
TEST(FilteredManyEdges, AreAnsweredInBatchesAtContact) {
  workloads::Workload workload;
  workload.family = Family::Star, workload.vertices = 192;
  const Polygon polygon = in_plane(workloads::draw_outline(workload, 2026, 0));
  const filtered::PreparedPolygon prepared(polygon);
  std::vector<Ball> balls;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Random random(2026, i, 96);
    const Eigen::Vector3d near(random.unit() - 0.5, random.unit() - 0.5, random.unit() / 16);
    const Eigen::Vector3d center = Eigen::Vector3d(polygon.vertex(i % polygon.vertex_count())) + near;
    balls.push_back({center, filtered::answer({center, 0}, prepared).distance});
  }
  const std::unique_ptr<bool[]> touches(new bool[balls.size()]);
  filtered::contact(balls, prepared, {touches.get(), balls.size()});
  for (std::size_t i = 0; i < balls.size(); ++i)
    EXPECT_EQ(touches[i], filtered::contact(balls[i], prepared)) << "ball " << i;
}

// The distance of the plane, in units of the polygon's size, exceeds what squares can hold.
TEST(FilteredManyEdges, InAPlaneFarFromTheOriginAreAnsweredAsByExact) {
  workloads::Workload workload;
  workload.family = Family::Star, workload.vertices = 48;
  const workloads::Outline outline = workloads::draw_outline(workload, 2026, 0);
  for (const int exponent : {80, 200, 500, 600, 900}) {
    const Polygon polygon = in_plane(outline, std::ldexp(1.0, exponent));
    const filtered::PreparedPolygon prepared(polygon);
    const exact::PreparedPolygon truth(polygon);
    for (std::uint64_t i = 0; i < 50; ++i) {
      Random random(2026, i, 98);
      const Ball ball = draw_ball(random, polygon);
      const std::string what = "2^" + std::to_string(exponent) + " above the origin, ball " + std::to_string(i);
      EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "") << what;
    }
  }
}

// More loops than a node of the hierarchy has children: whole loops are told from the foot without a look at them.

/// A square of side 4 `count`, seen from above, in a plane of slope 1/2, with count x count square holes of side 2.
Polygon sieve(int count) {
  const auto square = [](double x, double y, double side) {
    const auto place = [](double u, double v) { return Eigen::Vector3d(u, v, u / 2); };
    return Loop{place(x, y), place(x + side, y), place(x + side, y + side), place(x, y + side)};
  };
  std::vector<Loop> holes;
  for (int row = 0; row < count; ++row)
    for (int column = 0; column < count; ++column) holes.push_back(square(4 * column + 1, 4 * row + 1, 2));
  return Polygon(square(0, 0, 4 * count), holes);
}

// Every answer is that of exact: the foot on rims, in holes, between them, outside, level with loops or with none.
TEST(FilteredManyHoles, AreAnsweredAsByExact) {
  for (const int count : {2, 3, 5, 9}) {
    const Polygon polygon = sieve(count);
    const filtered::PreparedPolygon prepared(polygon);
    const exact::PreparedPolygon truth(polygon);
    for (double y = -1; y <= 4 * count + 1; ++y)
      for (double x = -1; x <= 4 * count + 1; x += 1.5)
        for (const double radius : {0.0, 0.75}) {
          const Ball ball{{x, y, x / 2}, radius};
          EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "")
              << count << " holes a row, centre " << x << ", " << y << ", radius " << radius;
        }
  }
}

// A ball about a vertex overlaps however small it is, and touches where it is a point.
TEST(FilteredManyHoles, OverlapBallsOfAnySizeAboutTheirVertices) {
  const Polygon polygon = sieve(2);
  const filtered::PreparedPolygon prepared(polygon);
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i)
    for (const double radius : {0.0, 0x1p-1000, 0x1p-500, 0x1p-300, 0x1p-60}) {
      const Ball ball{polygon.vertex(i), radius};
      EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, polygon)), "") << "vertex " << i << ", " << radius;
      EXPECT_EQ(filtered::relation(ball, prepared), radius > 0 ? Relation::Overlapping : Relation::Touching)
          << "vertex " << i << ", " << radius;
    }
}

}  // namespace
}  // namespace touchstone::filtered_tests

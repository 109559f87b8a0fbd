// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles cover their polygon once, by exact areas.
#include "experiments/methods/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "experiments/cases/workloads/outline.h"
#include "experiments/cases/workloads/workload.h"

namespace touchstone::methods {
namespace {

/// Returns twice the area, signed as seen from above; exact for whole coordinates below 2^24.
double twice_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return (b - a).cross(c - a).z();
}

Loop lifted(const workloads::LatticeLoop& loop) {
  Loop result;
  for (const auto& [x, y] : loop) {
    const auto u = static_cast<double>(x), v = static_cast<double>(y);
    result.emplace_back(u, v, u - v);
  }
  return result;
}

TEST(Triangulate, CoversEveryPolygonOnceAndTurnsAsItDoes) {
  constexpr std::uint64_t kOutlineSeed = 52;
  using workloads::Family;
  for (const Family family : {Family::Star, Family::Comb, Family::Spiral, Family::RandomSimple, Family::L})
    for (std::uint64_t i = 0; i < TOUCHSTONE_SAMPLES / 5 + 1; ++i) {
      const workloads::Workload workload{.family = family, .holes = i % 4};
      const workloads::Outline outline = workloads::draw_outline(workload, kOutlineSeed, i);
      std::vector<Loop> holes;
      std::int64_t area = std::abs(workloads::twice_area(outline.outer));
      for (const auto& hole : outline.holes) {
        area -= std::abs(workloads::twice_area(hole));
        holes.push_back(lifted(hole));
      }
      if (workloads::twice_area(outline.outer) < 0) area = -area;
      const Polygon polygon(lifted(outline.outer), holes);
      const auto triangles = triangulate(polygon);
      EXPECT_EQ(triangles.size(), polygon.vertex_count() - 2 + 2 * holes.size())
          << "seed " << kOutlineSeed << ", " << i;
      double sum = 0;
      for (const auto& [a, b, c] : triangles) {
        const double part = twice_area(polygon.vertex(a), polygon.vertex(b), polygon.vertex(c));
        EXPECT_EQ(part > 0, area > 0) << "seed " << kOutlineSeed << ", " << i;
        sum += part;
      }
      EXPECT_EQ(sum, static_cast<double>(area)) << "seed " << kOutlineSeed << ", " << i;
    }
}

TEST(Triangulate, FillsAnIslandInAHole) {
  const auto square = [](double half) {
    return Loop{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  };
  const Polygon polygon(square(3), {square(2), square(1)});
  double sum = 0;
  for (const auto& [a, b, c] : triangulate(polygon))
    sum += twice_area(polygon.vertex(a), polygon.vertex(b), polygon.vertex(c));
  EXPECT_EQ(sum, 2 * (36 - 16 + 4));
}

}  // namespace
}  // namespace touchstone::methods

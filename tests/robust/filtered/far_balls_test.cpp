// SPDX-License-Identifier: GPL-3.0-or-later
// Balls many sizes away from the polygon, or it from the origin: what doubles may be off grows with the distance.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"
#include "tests/robust/filtered/wrong_answers.h"

namespace touchstone::filtered_tests {
namespace {

using workloads::Family;
using workloads::Placement;
using workloads::Random;

/// A direction in space, in the polygon's plane or along its normal, each with some noise.
Eigen::Vector3d draw_direction(Random& random, const workloads::Frame& frame) {
  const Eigen::Vector3d part{2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1};
  const double in_plane = random.coin() ? 1 : 0x1p-20, off_plane = random.coin() ? 1 : 0x1p-20;
  const Eigen::Vector3d direction =
      in_plane * (part.x() * frame.u + part.y() * frame.v) + off_plane * part.z() * frame.w;
  return direction.normalized();
}

// The radius crosses the exact distance double by double, where a bound for near balls would be sure and wrong.
TEST(FilteredFarBalls, AreAnsweredAsByExactAcrossTheDistance) {
  std::uint64_t sample = 0;
  for (const Family family : {Family::Star, Family::Comb, Family::Triangle})
    for (const Placement placement : {Placement::LatticeFrame, Placement::Rotated})
      for (int exponent = 1; exponent <= 58; exponent += 3) {
        const workloads::Workload workload{.family = family, .placement = placement, .vertices = 12};
        const auto placed = workloads::draw_placed_outline(workload, 2026, sample);
        const exact::PreparedPolygon truth(placed.polygon);
        const filtered::PreparedPolygon prepared(placed.polygon);
        Random random(2026, sample, 98);
        const double size =
            placed.frame.unit * static_cast<double>(workloads::bounding_box(placed.outline.outer).size());
        const Eigen::Vector3d center =
            placed.frame.origin + std::ldexp(size, exponent) * draw_direction(random, placed.frame);
        const double distance = exact::answer({center, 0}, truth).distance;
        for (std::int64_t steps = -4; steps <= 4; ++steps) {
          const Ball ball{center, workloads::move_by_doubles(distance, steps)};
          EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "")
              << "sample " << sample << ", 2^" << exponent << " sizes away, " << steps << " doubles";
        }
        ++sample;
      }
}

// Only what is parallel to a coordinate plane can be that far from the origin. Centres lie about the origin, so that
// squares of the distance overflow.
TEST(FilteredFarBalls, AreAnsweredAsByExactWherePolygonsAreAnyNumberOfSizesAway) {
  for (int exponent = 0; exponent <= 1020; exponent += 5)
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {0, 3, 0}, {0, 1, 1}, {0, 0, 3}};
      for (Eigen::Vector3d& corner : corners) {
        corner.x() = std::ldexp(1, exponent);
        corner = Eigen::Vector3d(corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
      }
      const Polygon polygon({corners});
      const exact::PreparedPolygon truth(polygon);
      const filtered::PreparedPolygon prepared(polygon);
      for (const double beside : {-0x1p-1074, 0.0, 0x1p-30, 2.0})
        for (const double radius : {1.0, std::ldexp(1 - 0x1p-53, exponent), std::ldexp(1, exponent)}) {
          Eigen::Vector3d center(0, beside, 0);
          center = Eigen::Vector3d(center[axis], center[(axis + 1) % 3], center[(axis + 2) % 3]);
          const Ball ball{center, radius};
          EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "")
              << "2^" << exponent << " along axis " << (3 - axis) % 3 << ", " << beside << " beside, radius " << radius;
        }
    }
}

}  // namespace
}  // namespace touchstone::filtered_tests

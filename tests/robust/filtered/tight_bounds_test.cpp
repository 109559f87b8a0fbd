// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds where they are tight: shapes are such that roundings add up, and each radius is the one at which the filter
// begins to be certain. A bound of which only a twentieth is taken, or of floats a thirty-second, gives wrong answers
// here, and hardly anywhere else.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/shapes/polygon.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"
#include "robust/filtered/detail/sets/triangle_groups_contact.h"
#include "robust/filtered/filtered.h"
#include "tests/robust/support/environment.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;
using workloads::Random;

Eigen::Vector3d draw_vector(Random& random) {
  const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1;
  return {x, y, 2 * random.unit() - 1};
}
/// About as long in every coordinate.
Eigen::Vector3d draw_diagonal(Random& random) {
  const auto side = [&] { return random.coin() ? 1.0 : -1.0; };
  const double x = side(), y = side();
  return Eigen::Vector3d(x, y, side()) * (0.9 + 0.2 * random.unit()) + 0.05 * draw_vector(random);
}

// Normals near (1, 1, 1), and balls so far away that the error is that of their own coordinates.
TEST(TightBounds, SidesOfPlanesFarAwayAreExactInEveryState) {
  std::uint64_t asked = 0;
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 61);
    const Eigen::Vector3d first = Eigen::Vector3d(1, -1, 0) + 0.01 * draw_vector(random);
    const Eigen::Vector3d second = Eigen::Vector3d(0, 1, -1) + 0.01 * draw_vector(random);
    const Eigen::Vector3d corner = draw_vector(random);
    const Polygon polygon({corner, corner + first, corner + second});
    if (exact::validate(polygon)) continue;
    const filtered::PreparedPolygon prepared(polygon);
    const double far = std::ldexp(1 + random.unit(), static_cast<int>(random.integer(-2, 30)));
    const Eigen::Vector3d center = corner + (first + second) / 3 + far * first.cross(second).normalized();
    const double distance = exact::answer({center, 0}, polygon).distance;
    for (int steps = -2; steps <= 2; ++steps) {
      const Ball ball{center, workloads::move_by_doubles(distance, steps)};
      const PlaneSide truth = exact::plane_side(ball, polygon);
      for (const State& state : kStates) {
        const Environment changed(state);
        EXPECT_EQ(filtered::plane_side(ball, prepared), truth) << "index " << index << ", " << steps << ", " << state;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 1000 * TOUCHSTONE_SAMPLES);
}

/// Returns the first radius from `near` on, upwards, with which the lane's triangle is certainly touched, or downwards,
/// missed. Steps are smaller than a float's.
double first_certain(const filtered::detail::LaneDistances& distances, unsigned lane, double near, bool touched) {
  constexpr double kStep = 0x1p-25;
  double radius = near;
  const auto is_certain = [&] {
    return ((touched ? distances.touched(radius) : distances.missed(radius)) >> lane & 1) != 0;
  };
  while (!is_certain()) radius *= touched ? 1 + kStep : 1 - kStep;
  return radius;
}

// Groups of small triangles and centres far from them, so that the error is that of floats and not of what is stored.
TEST(TightBounds, FloatsAreRightWhereTheyBeginToBeCertain) {
  using namespace filtered::detail;
  std::uint64_t asked = 0;
  for (std::uint64_t index = 0; index < 60 * TOUCHSTONE_SAMPLES; ++index) {
    Random random(2026, index, 62);
    std::vector<Triangle> triangles;
    while (triangles.size() < TriangleGroup::kWidth)
      triangles.push_back({draw_vector(random), draw_vector(random), draw_vector(random)});
    const TriangleGroup group = group_of(triangles);
    const Ball center{draw_diagonal(random) * std::ldexp(1, static_cast<int>(random.integer(6, 12))), 0};
    for (const int mode : kModes) {
      double seen[4];
      std::vector<std::optional<double>> touching(triangles.size()), missing(triangles.size());
      {
        const Environment changed(mode, Environment::kKeep);
        if (!see(center, group, seen)) continue;
        const LaneDistances distances = LaneTriangles(group).distances(seen);
        float most[kFloatLanes];
        store(most, distances.most);
        for (unsigned lane = 0; lane < triangles.size(); ++lane) {
          const double distance = static_cast<double>(most[lane]) / TriangleGroup::kSteps,
                       off = distances.error(distance);
          touching[lane] = first_certain(distances, lane, distance + off * (1 - 0x1p-10), true) / group.scale;
          missing[lane] = first_certain(distances, lane, distance - off * (1 - 0x1p-10), false) / group.scale;
        }
      }
      for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
        const Triangle& t = triangles[lane];
        const exact::PreparedPolygon polygon(Polygon({t.a, t.b, t.c}));
        EXPECT_TRUE(exact::contact({center.center, *touching[lane]}, polygon)) << index << ' ' << lane << ' ' << mode;
        EXPECT_FALSE(exact::contact({center.center, *missing[lane]}, polygon)) << index << ' ' << lane << ' ' << mode;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 1000 * TOUCHSTONE_SAMPLES);
}

}  // namespace
}  // namespace touchstone::filtered_tests

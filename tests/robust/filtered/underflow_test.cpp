// SPDX-License-Identifier: GPL-3.0-or-later
// Centres closer to a polygon at the origin than squares and error terms can be told in doubles, at every exponent.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/exact.h"
#include "robust/filtered/motion.h"
#include "tests/robust/filtered/wrong_answers.h"
#include "tests/robust/support/printing.h"
#include "tests/robust/support/rearranged.h"

namespace touchstone::filtered_tests {
namespace {

using namespace contact_tests;

/// Of the size of 1, with a vertex at the origin and an edge along x; flat, tilted, off its plane, with a hole.
const std::vector<Polygon>& polygons_at_origin() {
  static const std::vector<Polygon> polygons{
      Polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
      Polygon({{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0.7}}),
      Polygon({{0, 0, 0}, {1, 0.5, 0.25}, {0.3, 0.8, 0.7}}),
      Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.125}, {0, 1, 0}}),
      Polygon({{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}}),
      Polygon({{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}),
      Polygon({{-0x1p-300, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
  };
  return polygons;
}

/// Towards vertex, edge and face, with all bits.
std::vector<Eigen::Vector3d> directions(workloads::Random& random) {
  std::vector<Eigen::Vector3d> list;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}})
    list.push_back({x * (1 + random.unit()), y * (1 + random.unit()), 1 + random.unit()});
  list.emplace_back(1 + random.unit(), 0, 0);
  return list;
}

TEST(FilteredUnderflow, ChangesNoAnswerAtAnyExponent) {
  for (int exponent = -1074; exponent <= -60; exponent += exponent < -960 ? 1 : 5)
    for (std::size_t i = 0; i < polygons_at_origin().size(); ++i) {
      const Polygon& polygon = polygons_at_origin()[i];
      const filtered::PreparedPolygon prepared(polygon);
      const exact::PreparedPolygon truth(polygon);
      workloads::Random random(2026, static_cast<std::uint64_t>(exponent + 1074), i);
      for (const Eigen::Vector3d& direction : directions(random)) {
        const Eigen::Vector3d center = std::ldexp(1.0, exponent) * direction;
        const double distance = exact::answer({center, 0}, truth).distance;
        for (const double radius : {0.0, distance, std::nextafter(distance, 1.0), std::ldexp(1.0, exponent)}) {
          const Ball ball{center, radius};
          EXPECT_EQ(wrong_answers(ball, prepared, exact::answer(ball, truth)), "")
              << "polygon " << i << ", 2^" << exponent << ", radius " << radius;
          if (polygon.vertex_count() != 3) continue;
          EXPECT_EQ(filtered::contact(ball, triangle_of(polygon)), exact::contact(ball, truth))
              << "triangle " << i << ", 2^" << exponent << ", radius " << radius;
        }
      }
    }
}

// A large triangle and a centre far below its last place: scaled to integers, the centre would vanish.
TEST(FilteredUnderflow, MakesNoWholeNumberOfWhatScalingWouldLose) {
  for (int size = 40; size <= 63; ++size)
    for (int exponent = -1074; exponent <= -1020; ++exponent) {
      const double s = std::ldexp(1.0, size), offset = std::ldexp(1.0, exponent);
      const Triangle triangle{{0, 0, 0}, {s, 0, 0}, {0, s, 0}};
      const Polygon polygon({triangle.a, triangle.b, triangle.c});
      const exact::PreparedPolygon truth(polygon);
      const filtered::PreparedPolygon prepared(polygon);
      for (const Eigen::Vector3d& center :
           {Eigen::Vector3d(s / 4, s / 4, offset), Eigen::Vector3d(s / 2, -offset, 0), Eigen::Vector3d(-offset, 0, 0)})
        for (const double radius : {0.0, 0x1p-1074}) {
          const Ball ball{center, radius};
          EXPECT_EQ(filtered::contact(ball, triangle), exact::contact(ball, truth))
              << "2^" << size << ", 2^" << exponent;
          EXPECT_EQ(filtered::answer(ball, prepared), exact::answer(ball, truth)) << "2^" << size << ", 2^" << exponent;
        }
    }
}

// A component of the normal that is not zero, but is after scaling: the closest point moves along it all the same.
TEST(FilteredUnderflow, DoesNotTakeALostComponentOfTheNormalForZero) {
  const Polygon polygon({{-1, -1, -8e-323}, {1, -1, -8e-323}, {0, 1, 8e-323}});
  const Ball ball{{0, 0, 1048576}, 1};
  const Answer answer = filtered::answer(ball, filtered::PreparedPolygon(polygon));
  EXPECT_EQ(answer, exact::answer(ball, exact::PreparedPolygon(polygon)));
  EXPECT_NE(answer.point.y(), 0);
}

/// A centre beside the edge from the origin to (tiny, 1, 1), whose length is 2^`size` times that, and the least doubles
/// along x off the plane x = 0. So x of the normal there is subnormal, or is after a division by a short distance.
struct BesideTinyEdge {
  Triangle triangle;
  Eigen::Vector3d center;
};
BesideTinyEdge beside_tiny_edge(workloads::Random& random) {
  const auto tiny = [&random] {
    const auto most = std::int64_t{1} << random.integer(0, 40);
    return 0x1p-1074 * static_cast<double>(random.integer(-most, most));
  };
  const double edge = 0x1p-1074 * static_cast<double>(random.integer(1, std::int64_t{1} << random.integer(0, 40)));
  const double size = std::ldexp(1.0, static_cast<int>(random.integer(-40, 0)));
  const double away = std::ldexp(1 + random.unit(), static_cast<int>(random.integer(-40, -1)));
  const double along = 0.25 + random.unit() / 4, x = random.coin() ? 0 : tiny();
  return {{{0, 0, 0}, {edge, size, size}, {0, size, 0}}, {x, along * size, (along + away) * size}};
}

// The error bound of such a component underflows with it: 0 of 0 is not exact.
TEST(FilteredUnderflow, TakesNoComponentOfTheNormalForZeroWhoseErrorUnderflows) {
  int not_zero = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    workloads::Random random(2026, i, 96);
    const auto [t, center] = beside_tiny_edge(random);
    const Polygon polygon({t.a, t.b, t.c});
    const Answer truth = exact::answer({center, 1}, polygon);
    not_zero += truth.nearest.kind == Feature::Kind::Edge && truth.contact_normal.x() != 0;
    EXPECT_EQ(filtered::closest(center, t).contact_normal, truth.contact_normal) << "index " << i;
    EXPECT_EQ(filtered::answer({center, 1}, filtered::PreparedPolygon(polygon)), truth) << "index " << i;
    EXPECT_EQ(filtered::first_contact({{center, 1}, {5, 5, 5}}, t).contact_normal, truth.contact_normal) << i;
  }
  EXPECT_GT(not_zero, 200);
}

}  // namespace
}  // namespace touchstone::filtered_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// The queries that are timed: functions of (seed, index), distinct, and as near to touching as they promise.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "experiments/cases/workloads/triangle_queries.h"
#include "experiments/methods/triangle_contacts.h"
#include "experiments/studies/bench/polygon_queries.h"
#include "geometry/contact/fast.h"
#include "robust/exact/exact.h"
#include "robust/exact/validate.h"

namespace touchstone::bench {
namespace {

constexpr std::uint64_t kQueries = 1000;

Polygon polygon_of(const Triangle& t) { return Polygon({t.a, t.b, t.c}); }

bool equal(const workloads::TriangleQuery& x, const workloads::TriangleQuery& y) {
  return x.ball.center == y.ball.center && x.ball.radius == y.ball.radius && x.triangle.a == y.triangle.a &&
         x.triangle.b == y.triangle.b && x.triangle.c == y.triangle.c;
}

TEST(BenchTriangles, AreFunctionsOfSeedAndIndexAndDistinct) {
  for (const workloads::TriangleFamily family : workloads::all_triangle_families()) {
    std::set<std::tuple<double, double, double, double>> seen;
    for (std::uint64_t i = 0; i < kQueries; ++i) {
      const workloads::TriangleQuery query = workloads::draw_triangle_query(family, 3, i);
      const auto& [ball, triangle] = query;
      seen.insert({ball.center.x(), ball.center.y(), triangle.a.z(), triangle.b.x()});
      if (i % 50 == 0) {
        EXPECT_TRUE(equal(query, workloads::draw_triangle_query(family, 3, i)));
        EXPECT_FALSE(equal(query, workloads::draw_triangle_query(family, 4, i)));
      }
    }
    EXPECT_GT(seen.size(), kQueries * 99 / 100) << to_string(family);
  }
}

TEST(BenchTriangles, AreAcceptedByTheContract) {
  for (const workloads::TriangleFamily family : workloads::all_triangle_families())
    for (std::uint64_t i = 0; i < kQueries / 5; ++i) {
      const workloads::TriangleQuery query = workloads::draw_triangle_query(family, 1, i);
      EXPECT_FALSE(find_fault(query.ball)) << to_string(family) << i;
      EXPECT_FALSE(exact::validate(polygon_of(query.triangle))) << to_string(family) << i;
    }
}

// Two radii a relative 2^-49 apart enclose the exact distance; of either side and every kind of feature there are many.
TEST(BenchTriangles, HalfOfHalfNearIsNear) {
  std::uint64_t near = 0, touch = 0;
  std::map<Feature::Kind, std::uint64_t> kinds;
  for (std::uint64_t i = 0; i < kQueries; ++i) {
    const auto [ball, triangle] = workloads::draw_triangle_query(workloads::TriangleFamily::HalfNear, 1, i);
    const Polygon polygon = polygon_of(triangle);
    const Ball smaller{ball.center, ball.radius * (1 - 0x1p-49)}, larger{ball.center, ball.radius * (1 + 0x1p-49)};
    if (exact::relation(smaller, polygon) != Relation::Separate) continue;
    if (exact::relation(larger, polygon) != Relation::Overlapping) continue;
    ++near;
    ++kinds[exact::answer(ball, polygon).nearest.kind];
    const Relation relation = exact::relation(ball, polygon);
    EXPECT_NE(relation, Relation::Touching);
    if (relation == Relation::Overlapping) ++touch;
  }
  EXPECT_NEAR(static_cast<double>(near), kQueries / 2.0, kQueries / 10.0);
  EXPECT_NEAR(static_cast<double>(touch), static_cast<double>(near) / 2, kQueries / 10.0);
  EXPECT_EQ(kinds.size(), 3U);
  for (const auto& [kind, count] : kinds) EXPECT_GT(count, near / 5) << to_string(kind);
}

TEST(BenchTriangles, LatticeTangentsTouchExactly) {
  std::map<Feature::Kind, std::uint64_t> kinds;
  double largest = 0;
  for (std::uint64_t i = 0; i < kQueries; ++i) {
    const auto [ball, triangle] = workloads::draw_triangle_query(workloads::TriangleFamily::LatticeTangent, 1, i);
    const Answer answer = exact::answer(ball, polygon_of(triangle));
    ASSERT_EQ(answer.relation, Relation::Touching) << i;
    ++kinds[answer.nearest.kind];
    for (const Eigen::Vector3d& v :
         {triangle.a, triangle.b, triangle.c, ball.center, Eigen::Vector3d(ball.radius, 0, 0)})
      for (const double x : v) {
        EXPECT_EQ(x, std::round(x));
        largest = std::max(largest, std::abs(x));
      }
  }
  EXPECT_LE(largest, workloads::kLargestCoordinate);
  EXPECT_GT(largest, workloads::kLargestCoordinate / 2);
  EXPECT_EQ(kinds.size(), 3U);
  for (const auto& [kind, count] : kinds) EXPECT_GT(count, kQueries / 5) << to_string(kind);
}

TEST(BenchTriangles, SliversAreThinAndFarIsFar) {
  for (std::uint64_t i = 0; i < kQueries; ++i) {
    const Triangle sliver = workloads::draw_triangle_query(workloads::TriangleFamily::Slivers, 1, i).triangle;
    const double area = (sliver.b - sliver.a).cross(sliver.c - sliver.a).norm();
    const double longest = std::max({(sliver.b - sliver.a).squaredNorm(), (sliver.c - sliver.b).squaredNorm(),
                                     (sliver.a - sliver.c).squaredNorm()});
    EXPECT_NEAR(area / longest, 1e-8, 1e-9);
    const workloads::TriangleQuery far = workloads::draw_triangle_query(workloads::TriangleFamily::Far, 1, i);
    EXPECT_NEAR(far.triangle.a.norm(), 1e6, 10);
    EXPECT_LT((far.triangle.a - far.ball.center).norm(), 2);
  }
}

TEST(BenchTriangles, EricsonIsRightAwayFromTheThreshold) {
  for (std::uint64_t i = 0; i < kQueries; ++i) {
    const auto [ball, triangle] = workloads::draw_triangle_query(workloads::TriangleFamily::Random, 1, i);
    EXPECT_EQ(methods::ericson_contact(ball, triangle), exact::contact(ball, polygon_of(triangle))) << i;
  }
}

TEST(BenchPolygons, AreFunctionsOfTheirArgumentsAndAsFarOffTheirPlaneAsTheySay) {
  for (const std::size_t vertices : {8U, 32U})
    for (const auto outline : outlines_of(vertices))
      for (const OffPlane& off_plane : all_off_plane()) {
        const Polygon planar = draw_polygon(outline, vertices, 1, 2), polygon = move_off_plane(planar, off_plane, 1, 2);
        EXPECT_EQ(planar, draw_polygon(outline, vertices, 1, 2));
        EXPECT_EQ(polygon, move_off_plane(planar, off_plane, 1, 2));
        EXPECT_FALSE(exact::validate(polygon));
        double size = 0;
        for (int axis = 0; axis < 3; ++axis) {
          const auto [low, high] = std::ranges::minmax_element(polygon.coordinates(axis));
          size = std::max(size, *high - *low);
        }
        const double moved = exact::answer({polygon.vertex(0), 0}, polygon).off_plane / size;
        EXPECT_LE(moved, 16 * off_plane.share) << to_string(outline) << ' ' << off_plane.name;
        EXPECT_GE(moved, off_plane.share / 8) << to_string(outline) << ' ' << off_plane.name;
      }
}

TEST(BenchPolygons, BallsMeetThePlaneInTurnAndSomeTouch) {
  std::vector<Polygon> polygons;
  std::vector<exact::PreparedPolygon> prepared;
  for (std::uint64_t i = 0; i < 4; ++i) {
    polygons.push_back(draw_polygon(workloads::Family::Star, 32, 1, i));
    prepared.emplace_back(polygons.back());
  }
  const auto queries = draw_balls(polygons, 1, kQueries);
  ASSERT_EQ(queries.size(), kQueries);
  const auto fewer = draw_balls(polygons, 1, 10);
  std::uint64_t touching = 0, across = 0;
  for (std::size_t i = 0; i < kQueries; ++i) {
    EXPECT_EQ(queries[i].polygon, i % 4);
    if (i < fewer.size()) {
      EXPECT_EQ(queries[i].ball.center, fewer[i].ball.center);
    }
    const auto& polygon = prepared[queries[i].polygon];
    if (exact::plane_side(queries[i].ball, polygon) == PlaneSide::Intersects) ++across;
    if (exact::contact(queries[i].ball, polygon)) ++touching;
  }
  EXPECT_GE(across, kQueries * 99 / 100);
  EXPECT_GT(touching, kQueries / 10);
  EXPECT_LT(touching, kQueries * 9 / 10);
}

}  // namespace
}  // namespace touchstone::bench

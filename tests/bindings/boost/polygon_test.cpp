// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of Boost.Geometry in space: their vertices, rings and faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <limits>
#include <string>

#include "bindings/boost/boost_geometry.h"
#include "robust/filtered/filtered.h"
#include "tests/experiments/support/message_of.h"

namespace touchstone::boost_geometry {
namespace {

using Point = boost::geometry::model::d2::point_xy<double>;
template <bool clockwise, bool closed, class P = Point>
using Flat = boost::geometry::model::polygon<P, clockwise, closed>;

const Loop kOuter{{0, 0, 7}, {0, 4, 7}, {4, 4, 7}, {4, 0, 7}}, kHole{{1, 1, 7}, {3, 1, 7}, {3, 3, 7}, {1, 3, 7}};

/// Returns a frame, whose outer ring runs clockwise.
template <class Polygon>
Polygon frame(bool closes) {
  Polygon flat;
  flat.outer() = {{0, 0}, {0, 4}, {4, 4}, {4, 0}};
  flat.inners() = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
  if (closes) {
    flat.outer().push_back(flat.outer().front());
    flat.inners()[0].push_back(flat.inners()[0].front());
  }
  return flat;
}

Pose at_seven() {
  Pose pose;
  pose.translation = {0, 0, 7};
  return pose;
}

TEST(BoostGeometry, PolygonsHaveTheNumbersOfTheirPointsWhicheverWayRingsAreDeclared) {
  const Polygon expected(kOuter, {kHole});
  EXPECT_EQ(polygon(frame<Flat<true, true>>(true), at_seven()), expected);
  EXPECT_EQ(polygon(frame<Flat<false, true>>(true), at_seven()), expected);
  EXPECT_EQ(polygon(frame<Flat<true, false>>(false), at_seven()), expected);
  EXPECT_EQ(polygon(frame<Flat<false, false>>(false), at_seven()), expected);
  using Floats = Flat<true, true, boost::geometry::model::d2::point_xy<float>>;
  EXPECT_EQ(polygon(frame<Floats>(true), at_seven()), expected);
  using Integers = Flat<true, true, boost::geometry::model::d2::point_xy<int>>;
  EXPECT_EQ(polygon(frame<Integers>(true), at_seven()), expected);
  static_assert(!PlanePolygon<Flat<true, true, boost::geometry::model::d2::point_xy<long double>>>);
  static_assert(!AnyPolygon<Point>);
}

TEST(BoostGeometry, FrontIsWhereTheOuterRingRunsCounterClockwise) {
  Flat<true, true> flat = frame<Flat<true, true>>(true);
  const auto side = [&] {
    return filtered::plane_side({{0, 0, 9}, 1}, filtered::PreparedPolygon(polygon(flat, at_seven())));
  };
  EXPECT_EQ(side(), PlaneSide::Behind);
  std::reverse(flat.outer().begin(), flat.outer().end());
  EXPECT_EQ(side(), PlaneSide::InFront);
}

TEST(BoostGeometry, PoseTurnsAndRoundsEachCoordinateOnce) {
  Pose pose;
  pose.rotation << 0.1, 0, 0, 0, 0.7, 0, 0, 0, 1;
  pose.translation = {0.3, 0, 0};
  const Polygon posed = polygon(frame<Flat<true, true>>(true), pose);
  for (std::size_t i = 0; i < 8; ++i) {
    const Eigen::Vector3d& p = i < 4 ? kOuter[i] : kHole[i - 4];
    EXPECT_EQ(posed.vertex(i), scene::posed(pose, {p.x(), p.y(), 0}));
  }
}

TEST(BoostGeometry, LiftGivesAnyPointInSpace) {
  using Point3 = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  Flat<true, true, Point3> flat;
  flat.outer() = {{0, 0, 1}, {4, 0, 2}, {0, 4, 3}, {0, 0, 1}};
  const auto lift = [](const Point3& p) { return Eigen::Vector3d(p.get<0>(), p.get<1>(), p.get<2>()); };
  EXPECT_EQ(polygon(flat, lift), Polygon({{0, 0, 1}, {4, 0, 2}, {0, 4, 3}}));
}

TEST(BoostGeometry, FaultsNameTheRing) {
  const auto fault = [](const auto& flat) { return run_tests::message_of<Rejected>([&] { (void)polygon(flat); }); };
  EXPECT_EQ(fault(frame<Flat<true, true>>(false)), "the outer ring is not closed: its last point is not its first");
  Flat<true, true> flat = frame<Flat<true, true>>(true);
  flat.inners().push_back({{1, 1}, {2, 2}, {1, 2}});
  EXPECT_EQ(fault(flat), "hole 1 is not closed: its last point is not its first");
  EXPECT_NE(fault(Flat<true, true>()), "");
  EXPECT_EQ(fault(Flat<true, true>()), fault(Flat<true, false>()));
  // A closed ring of a type that leaves rings open repeats a vertex.
  EXPECT_NE(fault(frame<Flat<true, false>>(true)), "");
  flat = frame<Flat<true, true>>(true);
  flat.outer()[1].x(std::numeric_limits<double>::infinity());
  EXPECT_NE(fault(flat), "");
}

}  // namespace
}  // namespace touchstone::boost_geometry

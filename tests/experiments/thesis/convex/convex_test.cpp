// SPDX-License-Identifier: GPL-3.0-or-later
// Hulls contain, convex parts cover: by areas, and by the answers of the two methods.
#include "experiments/thesis/convex/convex.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "experiments/cases/workloads/outline.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"
#include "experiments/methods/registry.h"
#include "robust/exact/exact.h"

namespace touchstone::convex {
namespace {

/// An outline in the plane z = x - y, with its holes.
Polygon drawn(workloads::Family family, std::uint64_t holes, std::uint64_t index) {
  const workloads::Workload workload{.family = family, .holes = holes};
  const workloads::Outline outline = workloads::draw_outline(workload, 63, index);
  const auto lifted = [](const workloads::LatticeLoop& loop) {
    Loop result;
    for (const auto& [x, y] : loop)
      result.emplace_back(static_cast<double>(x), static_cast<double>(y), static_cast<double>(x - y));
    return result;
  };
  std::vector<Loop> loops;
  for (const auto& hole : outline.holes) loops.push_back(lifted(hole));
  return Polygon(lifted(outline.outer), loops);
}

/// Twice the area seen from above without the holes, with the sign of the outer loop; exact for whole coordinates.
double twice_area(const Polygon& polygon) {
  std::vector<double> loops;
  for (std::size_t i = 0, loop = 0; i < polygon.vertex_count(); ++i) {
    if (i == polygon.loop_end(loop)) ++loop;
    loops.resize(loop + 1, 0);
    const Eigen::Vector3d a = polygon.vertex(i), b = polygon.vertex(polygon.next(i));
    loops[loop] += a.x() * b.y() - b.x() * a.y();
  }
  double twice = std::abs(loops.front());
  for (std::size_t hole = 1; hole < loops.size(); ++hole) twice -= std::abs(loops[hole]);
  return std::copysign(twice, loops.front());
}

/// Whether no corner turns against the others and, with `strictly`, none runs straight.
bool is_convex(const Polygon& polygon, bool strictly) {
  const double sign = twice_area(polygon) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    const Eigen::Vector3d a = polygon.vertex(i), b = polygon.vertex(polygon.next(i)),
                          c = polygon.vertex(polygon.next(polygon.next(i)));
    const double turn = sign * ((b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x()));
    if (strictly ? turn <= 0 : turn < 0) return false;
  }
  return true;
}

TEST(Convex, HullsContainAndPartsCover) {
  using workloads::Family;
  for (const Family family : {Family::Convex, Family::Star, Family::Comb, Family::RandomSimple, Family::L})
    for (std::uint64_t i = 0; i < 12; ++i) {
      const Polygon polygon = drawn(family, family == Family::Star ? i % 3 : 0, i), hull = convex_hull(polygon);
      EXPECT_TRUE(is_convex(hull, true));
      EXPECT_GE(std::abs(twice_area(hull)), std::abs(twice_area(polygon)));
      EXPECT_GT(twice_area(hull) * twice_area(polygon), 0);
      double sum = 0;
      const auto parts = convex_parts(polygon);
      for (const Polygon& part : parts) {
        EXPECT_TRUE(is_convex(part, false));
        sum += twice_area(part);
      }
      EXPECT_EQ(sum, twice_area(polygon));
      if (family == Family::Convex) {
        EXPECT_EQ(parts.size(), 1U);
        EXPECT_EQ(twice_area(hull), twice_area(polygon));
      }
    }
}

// In the notch of a U the hull touches what is not there; parts answer as the polygon does.
TEST(Convex, TheHullFillsANotchAndPartsDoNot) {
  const Polygon u({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {6, 9, 0}, {6, 3, 0}, {3, 3, 0}, {3, 9, 0}, {0, 9, 0}});
  add_methods();
  const auto hull = methods::find_method("hull")->prepare(u), parts = methods::find_method("convex-parts")->prepare(u);
  const auto says = [](const auto& method, const Ball& ball) {
    return method->ask(ball, cases::QueryKind::Contact).contact.value();
  };
  const Ball in_notch{{4.5, 7, 0.25}, 1}, on_wall{{1.5, 7, 0.25}, 1}, away{{20, 7, 0.25}, 1};
  EXPECT_TRUE(says(hull, in_notch) && says(hull, on_wall) && says(parts, on_wall));
  EXPECT_FALSE(says(parts, in_notch) || says(parts, away) || says(hull, away));
  workloads::Random random(9, 0);
  for (int i = 0; i < 300; ++i) {
    const Ball ball{{12 * random.unit() - 1, 12 * random.unit() - 1, random.unit()}, 0.5 + random.unit()};
    const bool touches = exact::contact(ball, u);
    EXPECT_EQ(says(parts, ball), touches);
    EXPECT_TRUE(says(hull, ball) || !touches);
  }
}

}  // namespace
}  // namespace touchstone::convex

// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/scene/detail/lifted_box.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"
#include "tests/robust/support/rational_plane.h"

namespace touchstone::scene_tests {
namespace {

using contact_tests::RationalPlane;
using contact_tests::rationals;
using workloads::Random;

/// Polygons of 3 to 40 vertices in any plane, off it by nothing to their size, far away or not, thin or not, with one
/// hole or none.
std::optional<Polygon> draw_polygon(std::uint64_t index) {
  Random random(2026, index, 63);
  const auto number = [&random] { return 2 * random.unit() - 1; };
  const auto point = [&] { return Eigen::Vector3d{number(), number(), number()}; };
  const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-200, 200)));
  const Eigen::Vector3d u = point(), v = random.coin() ? point() : std::ldexp(1.0, -10) * point();
  const Eigen::Vector3d at = random.coin() ? Eigen::Vector3d(0, 0, 0) : 0x1p20 * point();
  const double noise = random.coin() ? 0 : std::ldexp(1.0, -static_cast<int>(random.integer(1, 60)));
  const auto count = random.integer(3, 40);
  const auto loop = [&](double radius) {
    Loop result;
    for (std::int64_t i = 0; i < count; ++i) {
      const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(count);
      const double r = radius * (0.6 + 0.4 * random.unit());
      result.emplace_back(scale * (at + r * (std::cos(angle) * u + std::sin(angle) * v) + noise * point()));
    }
    return result;
  };
  try {
    const Loop outer = loop(1);
    Polygon polygon(outer, random.coin() ? std::vector<Loop>{} : std::vector<Loop>{loop(0.1)});
    if (!exact::validate(polygon)) return polygon;
  } catch (const Rejected&) {
  }
  return std::nullopt;
}

/// Does the box hold the vertex where it is lifted to, along the dropped axis?
bool holds_lifted(const Box& box, const RationalPlane& plane, const Eigen::Vector3d& vertex) {
  const auto axis = static_cast<Eigen::Index>(plane.dropped_axis);
  const mpq_class at = plane.lifted(rationals(vertex))[plane.dropped_axis];
  return mpq_class(box.low[axis]) <= at && at <= mpq_class(box.high[axis]);
}

TEST(LiftedBox, HoldsEveryLiftedVertexTightly) {
  int quick_ones = 0, all = 0;
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    const auto polygon = draw_polygon(index);
    if (!polygon) continue;
    const Box exact = scene::detail::lifted_box(*polygon, filtered::PreparedPolygon(*polygon));
    const auto quick = scene::detail::quick_lifted_box(*polygon);
    ++all, quick_ones += quick.has_value();
    const RationalPlane plane(*polygon);
    for (const Box& box : {exact, quick.value_or(exact)}) {
      for (std::size_t i = 0; i < polygon->vertex_count(); ++i) {
        const Eigen::Vector3d p = polygon->vertex(i);
        EXPECT_TRUE((box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all())
            << "sample " << index;
        EXPECT_TRUE(holds_lifted(box, plane, p)) << "sample " << index << ", vertex " << i;
      }
      if (quick) {
        const double size = (exact.high - exact.low).maxCoeff();
        EXPECT_LE((quick->high - exact.high).maxCoeff(), 0x1p-20 * size) << "sample " << index;
        EXPECT_LE((exact.low - quick->low).maxCoeff(), 0x1p-20 * size) << "sample " << index;
      }
    }
  }
  EXPECT_GT(quick_ones, all / 2);
}

// Between two axes neither may be left out: the exact normal decides by less than doubles see.
TEST(LiftedBox, IsWideAlongEveryAxisThatMayBeTheDroppedOne) {
  const Polygon polygon({{0, 0, 0}, {1, 0, 0x1p-54}, {1, 1, 1}, {0, 1, 1.25}});
  const auto box = scene::detail::quick_lifted_box(polygon);
  ASSERT_TRUE(box);
  const RationalPlane plane(polygon);
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) EXPECT_TRUE(holds_lifted(*box, plane, polygon.vertex(i)));
}

TEST(LiftedBox, IsLeftToTheExactPathWhereDoublesCannotTell) {
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{0, 0, 0}, {1, 0, 0}, {2, 0x1p-52, 0}})));
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{0, 0, 0}, {0x1p-400, 0, 0}, {0, 0x1p-400, 0}})));
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{-0x1p1023, 0, 0}, {0x1p1023, 0, 0}, {0, 1, 0}})));
}

}  // namespace
}  // namespace touchstone::scene_tests

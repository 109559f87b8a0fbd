// SPDX-License-Identifier: GPL-3.0-or-later
#include "robust/scene/detail/lifted_box.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "experiments/cases/workloads/random.h"
#include "robust/exact/validate.h"

namespace touchstone::scene_tests {
namespace {

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

/// The contract's lift, in rationals: the coordinate of each vertex along the dropped axis, and that axis.
std::pair<std::size_t, std::vector<mpq_class>> lifted(const Polygon& polygon) {
  const std::size_t n = polygon.loop_end(0);
  const auto at = [&](std::size_t i) {
    const Eigen::Vector3d p = polygon.vertex(i);
    return std::array<mpq_class, 3>{p[0], p[1], p[2]};
  };
  std::array<mpq_class, 3> normal, mean;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = at(i), q = at(polygon.next(i));
      normal[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
      mean[k] += p[k] / static_cast<unsigned long>(n);
    }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(normal[k]) > abs(normal[axis])) axis = k;
  std::vector<mpq_class> result;
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    const auto p = at(i);
    mpq_class height = 0;
    for (std::size_t k = 0; k < 3; ++k) height += normal[k] * (mean[k] - p[k]);
    result.emplace_back(p[axis] + height / normal[axis]);
  }
  return {axis, result};
}

TEST(LiftedBox, HoldsEveryLiftedVertexTightly) {
  int quick_ones = 0, all = 0;
  for (std::uint64_t index = 0; index < 20 * TOUCHSTONE_SAMPLES; ++index) {
    const auto polygon = draw_polygon(index);
    if (!polygon) continue;
    const Box exact = scene::detail::lifted_box(*polygon, filtered::PreparedPolygon(*polygon));
    const auto quick = scene::detail::quick_lifted_box(*polygon);
    ++all, quick_ones += quick.has_value();
    const auto [axis, coordinates] = lifted(*polygon);
    for (const Box& box : {exact, quick.value_or(exact)}) {
      for (std::size_t i = 0; i < polygon->vertex_count(); ++i) {
        const Eigen::Vector3d p = polygon->vertex(i);
        EXPECT_TRUE((box.low.array() <= p.array()).all() && (p.array() <= box.high.array()).all())
            << "sample " << index;
        const auto k = static_cast<Eigen::Index>(axis);
        EXPECT_TRUE(mpq_class(box.low[k]) <= coordinates[i] && coordinates[i] <= mpq_class(box.high[k]))
            << "sample " << index << ", vertex " << i;
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
  const auto [axis, coordinates] = lifted(polygon);
  for (const mpq_class& x : coordinates) {
    const auto k = static_cast<Eigen::Index>(axis);
    EXPECT_TRUE(mpq_class(box->low[k]) <= x && x <= mpq_class(box->high[k]));
  }
}

TEST(LiftedBox, IsLeftToTheExactPathWhereDoublesCannotTell) {
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{0, 0, 0}, {1, 0, 0}, {2, 0x1p-52, 0}})));
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{0, 0, 0}, {0x1p-400, 0, 0}, {0, 0x1p-400, 0}})));
  EXPECT_FALSE(scene::detail::quick_lifted_box(Polygon({{-0x1p1023, 0, 0}, {0x1p1023, 0, 0}, {0, 1, 0}})));
}

}  // namespace
}  // namespace touchstone::scene_tests

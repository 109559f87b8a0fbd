// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/tunnelling/passes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/random.h"
#include "experiments/cases/workloads/workload.h"

namespace touchstone::tunnelling {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kStream = 0x74756e6e656c;

/// Returns a direction, uniform on the sphere.
Vector3d any_direction(workloads::Random& random) {
  for (;;) {
    const Vector3d v(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
    const double square = v.squaredNorm();
    if (square > 0x1p-10 && square <= 1) return v / std::sqrt(square);
  }
}

/// Returns a random point of the box around the polygon.
Vector3d any_point(workloads::Random& random, const Polygon& polygon) {
  Vector3d low = polygon.vertex(0), high = low;
  for (std::size_t i = 1; i < polygon.vertex_count(); ++i) {
    low = low.cwiseMin(polygon.vertex(i));
    high = high.cwiseMax(polygon.vertex(i));
  }
  const Vector3d share(random.unit(), random.unit(), random.unit());
  return low + share.cwiseProduct(high - low);
}

}  // namespace

std::optional<Pass> draw_pass(std::size_t vertices, std::uint64_t seed, std::uint64_t n) try {
  const workloads::Workload workload{.family = workloads::all_families()[n % workloads::all_families().size()],
                                     .placement = workloads::Placement::Rotated,
                                     .vertices = vertices};
  Polygon polygon = workloads::sample(workload, seed, n).polygon;
  workloads::Random random(seed, n, kStream);
  const double extent = workloads::extent_of(polygon);
  const Vector3d through = any_point(random, polygon), half = extent / 2 * any_direction(random);
  return Pass{std::move(polygon), through - half, through + half, extent};
} catch (const std::invalid_argument&) {  // the workload found no such polygon
  return std::nullopt;
}

Ball place_of(const Motion& motion, std::size_t level, std::size_t i) {
  const double time = static_cast<double>(i) / static_cast<double>(std::size_t{1} << level);  // exact
  return {motion.ball.center + time * (motion.to - motion.ball.center), motion.ball.radius};
}

bool touches_at_steps(const Motion& motion, std::size_t level, const filtered::PreparedPolygon& polygon) {
  for (std::size_t i = 0; i <= std::size_t{1} << level; ++i)
    if (filtered::contact(place_of(motion, level, i), polygon)) return true;
  return false;
}

std::optional<std::size_t> first_level_that_touches(const Motion& motion, const filtered::PreparedPolygon& polygon) {
  // Place i of the most steps is one of 2^level steps if its last kMostLevel - level bits are 0.
  const auto asked = [&](std::size_t level, std::size_t i) { return level == 0 || i % 2 == 1; };
  for (std::size_t level = 0; level <= kMostLevel; ++level)
    for (std::size_t i = 0; i <= std::size_t{1} << level; ++i)
      if (asked(level, i) && filtered::contact(place_of(motion, level, i), polygon)) return level;
  return std::nullopt;
}

}  // namespace touchstone::tunnelling

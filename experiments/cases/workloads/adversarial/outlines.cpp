// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "experiments/cases/workloads/adversarial/shapes.h"
#include "experiments/cases/workloads/loops.h"
#include "experiments/cases/workloads/placement.h"
#include "robust/exact/validate.h"

namespace touchstone::workloads::adversarial {
namespace {

workloads::PlacedOutline draw_placed(Random& random) {
  const auto& families = workloads::all_families();
  const double distances[] = {0, 0, 1, 0x1p10, 0x1p20};
  workloads::Workload workload;
  workload.family =
      families[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(families.size()) - 1))];
  workload.placement = random.coin() ? Placement::LatticeFrame : Placement::Rotated;
  workload.vertices = static_cast<std::size_t>(random.integer(3, 24));
  workload.holes = static_cast<std::size_t>(random.integer(0, 2));
  workload.origin_distance = distances[random.integer(0, 4)];
  const std::uint64_t seed = random.bits();
  return workloads::draw_placed_outline(workload, seed, random.bits());
}

/// Moves every vertex by up to 2^warp sizes in every coordinate.
Polygon warped(Random& random, const Polygon& polygon, int warp) {
  const double reach = std::ldexp(size_of(polygon), warp);
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop)
      for (double& x : vertex) x += reach * (2 * random.unit() - 1);
  return polygon_of(loops);
}

/// Draws a ball above or below a lattice point near the outline, at a height that is an integer number of units and
/// equals the radius.
Ball tangent_ball(Random& random, const workloads::PlacedOutline& placed) {
  const auto box = workloads::bounding_box(placed.outline.outer);
  const auto& outer = placed.outline.outer;
  const auto& corner = outer[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(outer.size()) - 1))];
  const bool level = random.coin(), above_corner = level && random.coin();
  const auto x = static_cast<double>(above_corner ? corner.x : random.integer(box.low.x, box.high.x));
  const auto y = static_cast<double>(level ? corner.y : random.integer(box.low.y, box.high.y));
  const auto h = static_cast<double>(random.integer(-box.size(), box.size()));
  return {placed.frame.at(x, y, h), std::abs(h) * placed.frame.unit};
}

/// Moves the polygon so that one of its vertices lies at the origin.
Polygon moved_to_origin(Random& random, const Polygon& polygon) {
  const auto last = static_cast<std::int64_t>(polygon.vertex_count()) - 1;
  const Eigen::Vector3d there = polygon.vertex(static_cast<std::size_t>(random.integer(0, last)));
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops)
    for (Eigen::Vector3d& vertex : loop) vertex -= there;
  return polygon_of(loops);
}

Ball ball_near(Random& random, const Polygon& polygon) {
  switch (random.integer(0, 4)) {
    case 0: return {center_on_polygon(random, polygon), random.coin() ? 0 : size_of(polygon) * random.unit()};
    case 1: {
      const Eigen::Vector3d center = center_above_boundary(random, polygon);
      return {center, random.coin() ? 2 * size_of(polygon) : radius_at_threshold(random, center, polygon)};
    }
    default: {
      const Eigen::Vector3d center = center_off_feature(random, polygon);
      return {center, radius_at_threshold(random, center, polygon)};
    }
  }
}

/// Returns the largest magnitude of all coordinates and the radius.
double largest_number(const Ball& ball, const Polygon& polygon) {
  double largest = std::max(ball.radius, ball.center.cwiseAbs().maxCoeff());
  for (int axis = 0; axis < 3; ++axis)
    for (const double x : polygon.coordinates(axis)) largest = std::max(largest, std::abs(x));
  return largest;
}

/// Draws the exponent of the largest number after scaling.
int extreme_exponent(Random& random) {
  const auto about = [&](int exponent) { return exponent + static_cast<int>(random.integer(-3, 3)); };
  switch (random.integer(0, 6)) {
    case 0: return -1074 + static_cast<int>(random.integer(0, 60));
    case 1: return 1023 - static_cast<int>(random.integer(0, 3));
    case 2: return about(random.coin() ? 511 : -511);
    case 3: return about(random.coin() ? 255 : -255);
    case 4: return about(random.coin() ? 480 : -500);
    case 5: return about(random.coin() ? 64 : -64);
    default: return static_cast<int>(random.integer(-1074, 1023));
  }
}

}  // namespace

std::optional<BallAndPolygon> draw_outline(Random& random) try {
  auto placed = draw_placed(random);
  const bool warp = random.coin(), tangent = random.integer(0, 3) == 0 && placed.frame.unit >= 1;
  BallAndPolygon drawn{{}, placed.polygon};
  if (warp) drawn.polygon = warped(random, placed.polygon, static_cast<int>(random.integer(-52, -3)));
  if (random.integer(0, 7) == 0) {
    drawn.polygon = moved_to_origin(random, drawn.polygon);
    drawn.ball = ball_close_to_origin(random, drawn.polygon);
  } else {
    drawn.ball = tangent ? tangent_ball(random, placed) : ball_near(random, drawn.polygon);
  }
  if (random.integer(0, 2) == 0) {
    auto scaled = scaled_to_extremes(random, drawn.ball, drawn.polygon);
    if (!scaled) return std::nullopt;
    drawn = *std::move(scaled);
  }
  if (find_fault(drawn.ball) || exact::validate(drawn.polygon)) return std::nullopt;
  return drawn;
} catch (const Rejected&) {
  return std::nullopt;
} catch (const std::invalid_argument&) {  // the workload has no such outline
  return std::nullopt;
}

std::optional<BallAndPolygon> scaled_to_extremes(Random& random, const Ball& ball, const Polygon& polygon) {
  const double largest = largest_number(ball, polygon);
  const int shift = largest == 0 ? 0 : extreme_exponent(random) - std::ilogb(largest);
  const auto scaled = [shift](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(std::ldexp(v.x(), shift), std::ldexp(v.y(), shift), std::ldexp(v.z(), shift));
  };
  std::vector<Loop> loops = loops_of(polygon);
  for (Loop& loop : loops) std::transform(loop.begin(), loop.end(), loop.begin(), scaled);
  const Ball there{scaled(ball.center), std::ldexp(ball.radius, shift)};
  if (find_fault(there)) return std::nullopt;
  return BallAndPolygon{there, polygon_of(loops)};
}

double extreme_number(Random& random) {
  switch (random.integer(0, 3)) {
    case 0: return random.log_uniform(971, 1023);
    case 1: return random.log_uniform(-1074, -971);
    default: {
      const std::int64_t most = std::int64_t{1} << random.integer(0, 40);
      return 0x1p-1074 * static_cast<double>(random.integer(-most, most));
    }
  }
}

std::optional<BallAndPolygon> with_extreme_numbers(Random& random, const Ball& ball, const Polygon& polygon) try {
  std::vector<Loop> loops = loops_of(polygon);
  Ball there = ball;
  const auto always = static_cast<int>(random.integer(0, 2));
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t kind = random.integer(0, axis == always ? 2 : 5);
    if (kind > 2) continue;
    double largest = std::abs(ball.center[axis]);
    for (const double x : polygon.coordinates(axis)) largest = std::max(largest, std::abs(x));
    const auto highest = static_cast<int>(kind == 0 ? random.integer(971, 1022) : random.integer(-1074, -971));
    const int shift = largest == 0 ? 0 : highest - std::ilogb(largest);
    for (Loop& loop : loops)
      for (Eigen::Vector3d& vertex : loop) vertex[axis] = std::ldexp(vertex[axis], shift);
    there.center[axis] = random.coin() ? std::ldexp(ball.center[axis], shift) : extreme_number(random);
  }
  if (random.integer(0, 3) == 0) there.center[static_cast<int>(random.integer(0, 2))] = extreme_number(random);
  BallAndPolygon drawn{there, polygon_of(loops)};
  if (find_fault(drawn.ball) || exact::validate(drawn.polygon)) return std::nullopt;
  switch (random.integer(0, 3)) {
    case 0: break;
    case 1: drawn.ball.radius = std::abs(extreme_number(random)); break;
    default: drawn.ball.radius = radius_at_exact_threshold(random, there.center, drawn.polygon);
  }
  return drawn;
} catch (const Rejected&) {
  return std::nullopt;
}

}  // namespace touchstone::workloads::adversarial

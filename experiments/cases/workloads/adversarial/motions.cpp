// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/adversarial/motions.h"

#include <Eigen/Geometry>
#include <cmath>

#include "experiments/cases/workloads/adversarial/balls.h"
#include "experiments/cases/workloads/grazing_radius.h"
#include "experiments/cases/workloads/ulp.h"
#include "geometry/contact/fast_motion.h"
#include "robust/filtered/motion.h"

namespace touchstone::adversarial {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kStream = std::uint64_t{1} << 40;  // beyond the attempts of cases

/// Draws the way from the ball's place to the end, or from the start to that place.
Vector3d half_way(Random& random, const Case& drawn) {
  const Polygon& polygon = drawn.polygon;
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  const Vector3d edge = polygon.vertex(polygon.next(i)) - polygon.vertex(i),
                 from = drawn.ball.center - polygon.vertex(i);
  const double size = size_of(polygon), sign = random.coin() ? 1 : -1;
  const auto axis = static_cast<int>(random.integer(0, 2));
  switch (random.integer(0, 7)) {
    case 0: return Vector3d::Zero();
    case 1: return sign * edge;
    case 2: return sign * from;
    case 3: {  // at a right angle to the way from the vertex, exactly
      Vector3d across = Vector3d::Zero();
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      across[u] = from[v];
      across[v] = -from[u];
      return across;
    }
    case 4: return sign * std::exp2(std::ilogb(size)) * Vector3d::Unit(axis);
    case 5: return center_on_polygon(random, polygon) - drawn.ball.center;
    case 6: return edge.cross(from) / size;
    default: {
      const double length = size * std::abs(random.log_uniform(-40, 40));
      return length * Vector3d(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
    }
  }
}

double grazing(Random& random, const Motion& motion, const Case& drawn) {
  const fast::PreparedPolygon<double> rounded(drawn.polygon);
  const double estimate =
      workloads::grazing_radius(motion, [&](const Motion& asked) { return fast::contact(asked, rounded); });
  const auto threshold = [&](const auto& face) {
    return workloads::grazing_radius(
        motion, [&](const Motion& asked) { return filtered::contact(asked, face); }, estimate);
  };
  const auto triangle = drawn.triangle();
  const double radius = triangle ? threshold(*triangle) : threshold(filtered::PreparedPolygon(drawn.polygon));
  return workloads::move_radius_by_doubles(radius, random.integer(-1, 1));
}

}  // namespace

Motion draw_motion(const Case& drawn, std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index, kStream);
  const Vector3d half = half_way(random, drawn);
  const std::int64_t place = random.integer(0, 3);
  Motion motion{drawn.ball, drawn.ball.center};
  if (place != 1) motion.ball.center -= half;
  if (place != 2) motion.to += half;
  if (find_fault(motion)) return {drawn.ball, drawn.ball.center};
  if (random.integer(0, 3) == 0) motion.ball.radius = grazing(random, motion, drawn);
  return motion;
}

}  // namespace touchstone::adversarial

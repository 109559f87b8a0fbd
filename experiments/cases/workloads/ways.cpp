// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/ways.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/balls.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/exact.h"

namespace touchstone::workloads {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kStream = std::uint64_t{1} << 40;  // beyond those of the parts of a sample

double size_of(const PlacedOutline& placed) {
  return static_cast<double>(bounding_box(placed.outline.outer).size()) * placed.frame.unit;
}

/// Returns the direction, scaled by a power of two to about the length.
Vector3d of_length(const Vector3d& direction, double length) {
  const double largest = direction.cwiseAbs().maxCoeff();
  if (largest == 0) return direction;
  return std::ldexp(1.0, std::ilogb(length) - std::ilogb(largest)) * direction;
}

/// Returns a direction of the lattice.
Vector3d random_direction(Random& random, const Frame& frame) {
  const auto part = [&random] { return static_cast<double>(random.integer(-4, 4)); };
  const double x = part(), y = part(), h = part();
  return x * frame.u + y * frame.v + h * frame.w;
}

/// Returns a direction perpendicular to the one from the closest point to the centre.
Vector3d across(Random& random, const Ball& ball, const PlacedOutline& placed) {
  const Vector3d away = ball.center - exact::answer(ball, placed.polygon).point;
  const Vector3d axes[] = {placed.frame.u, placed.frame.v, placed.frame.w, random_direction(random, placed.frame)};
  return away.cross(axes[random.integer(0, 3)]);
}

/// Returns the direction of a random edge.
Vector3d along(Random& random, const Polygon& polygon) {
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(polygon.vertex_count()) - 1));
  const Vector3d edge = polygon.vertex(polygon.next(i)) - polygon.vertex(i);
  return random.coin() ? edge : Vector3d(-edge);
}

/// Returns the ball with its centre in the plane, and the radius that just fits there, moved by the workload's doubles.
Ball in_plane(const Ball& ball, const PlacedOutline& placed, int doubles) {
  const Frame& frame = placed.frame;
  const double height = std::round((ball.center - frame.origin).dot(frame.w) / (frame.unit * frame.unit));
  const Vector3d center = ball.center - height * frame.w;
  const double fit = exact::answer({center, 0}, placed.polygon).distance;
  return {center, fit > 0 ? std::max(0.0, move_by_doubles(fit, doubles)) : ball.radius};
}

Motion through(const Ball& ball, const Vector3d& half) {
  return {{ball.center - half, ball.radius}, ball.center + half};
}

}  // namespace

Motion draw_motion(const Ball& ball, const PlacedOutline& placed, const Workload& workload, std::uint64_t seed,
                   std::uint64_t index) {
  Random random(seed, index, kStream);
  const double length = std::ldexp(size_of(placed), static_cast<int>(random.integer(-3, 0)));
  const auto anywhere = [&] { return of_length(random_direction(random, placed.frame), length); };
  switch (workload.way) {
    case Way::Static:
    case Way::Rest: break;
    case Way::Anywhere: {
      Workload other = workload;
      other.ball = BallPlace::Anywhere;
      return {ball, draw_ball(placed, other, ~seed, index).center};
    }
    case Way::Start: return {ball, ball.center + anywhere()};
    case Way::End: return {{ball.center + anywhere(), ball.radius}, ball.center};
    case Way::Across: return through(ball, of_length(across(random, ball, placed), length));
    case Way::Along: return through(ball, of_length(along(random, placed.polygon), length));
    case Way::Through: return through(in_plane(ball, placed, workload.doubles), of_length(placed.frame.w, length));
  }
  return {ball, ball.center};
}

}  // namespace touchstone::workloads

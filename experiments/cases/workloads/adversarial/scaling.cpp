// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/adversarial/scaling.h"

#include <algorithm>
#include <cmath>

namespace touchstone::adversarial {
namespace {

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

}  // namespace touchstone::adversarial

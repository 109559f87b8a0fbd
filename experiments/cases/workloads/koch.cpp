// SPDX-License-Identifier: GPL-3.0-or-later
#include <mpfr.h>

#include <cmath>
#include <vector>

#include "experiments/cases/workloads/outline.h"

namespace touchstone::workloads {
namespace {

struct Point {
  double x, y;
};

/// Returns 4^(-1/dimension), the same double on every machine.
double koch_ratio(double dimension) {
  mpfr_t value;
  mpfr_init2(value, 200);
  mpfr_set_d(value, dimension, MPFR_RNDN);
  mpfr_si_div(value, -2, value, MPFR_RNDN);
  mpfr_exp2(value, value, MPFR_RNDN);
  const double ratio = mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  mpfr_free_cache();  // of this thread, which may end soon
  return ratio;
}

/// Returns a counterclockwise square or triangle about the origin, all vertices at the given distance from it.
std::vector<Point> base(Random& random, bool square, double radius) {
  const double half = std::sqrt(0.5), tall = std::sqrt(0.75);
  std::vector<Point> points = square ? std::vector<Point>{{half, half}, {-half, half}, {-half, -half}, {half, -half}}
                                     : std::vector<Point>{{0, 1}, {-tall, -0.5}, {tall, -0.5}};
  // A rational rotation, or none.
  const bool rotated = random.coin();
  const auto p = static_cast<double>(random.integer(1, 64));
  const auto q = static_cast<double>(rotated ? random.integer(-64, 64) : 0);
  const double cosine = (p * p - q * q) / (p * p + q * q), sine = 2 * p * q / (p * p + q * q);
  for (Point& point : points)
    point = {radius * (cosine * point.x - sine * point.y), radius * (sine * point.x + cosine * point.y)};
  return points;
}

/// Replaces every edge by four of `ratio` times its length, the middle two pointing to its right.
std::vector<Point> refined(const std::vector<Point>& points, double ratio) {
  const double height = std::sqrt(ratio - 0.25);
  std::vector<Point> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    const Point along{b.x - a.x, b.y - a.y};
    result.push_back(a);
    result.push_back({a.x + ratio * along.x, a.y + ratio * along.y});
    result.push_back({(a.x + b.x) / 2 + height * along.y, (a.y + b.y) / 2 - height * along.x});
    result.push_back({b.x - ratio * along.x, b.y - ratio * along.y});
  }
  return result;
}

}  // namespace

LatticeLoop koch(Random& random, std::size_t vertices, double dimension) {
  const bool square = random.coin();
  // The curve stays within sqrt(2) times the radius of the base.
  const double radius = static_cast<double>(kLatticeRadius) / 1.5 * (0.5 + 0.5 * random.unit());
  const double ratio = koch_ratio(dimension);

  std::vector<Point> points = base(random, square, radius);
  do points = refined(points, ratio);
  while (2 * vertices > 5 * points.size());  // 4 m is nearer to `vertices` than m

  LatticeLoop loop;
  for (const Point& point : points) loop.push_back({std::llround(point.x), std::llround(point.y)});
  return loop;
}

}  // namespace touchstone::workloads

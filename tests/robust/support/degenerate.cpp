// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/robust/support/degenerate.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace touchstone::contact_tests {
namespace {

using Eigen::Vector3d;

/// Of any size from the beginning.
int in_range(int lowest, int highest) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lowest, highest + 1));
}

Vector3d integer_point(int size) {
  const auto coordinate = [size] { return static_cast<double>(in_range(-size, size)); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

Vector3d times_power(const Vector3d& v, int exponent) {
  return v.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
}

/// A finite double of any exponent, or an end of their range.
double any_double() {
  const double end = *rc::gen::element(0.0, 5e-324, std::numeric_limits<double>::max());
  if (in_range(0, 3) == 0) return in_range(0, 1) == 0 ? end : -end;
  return std::ldexp(static_cast<double>(*rc::gen::arbitrary<std::int64_t>() >> 10), in_range(-1120, 970));
}
Vector3d any_point() {
  const double x = any_double(), y = any_double(), z = any_double();
  return {x, y, z};
}

/// A centre near points that have this size.
Vector3d center_near(const std::array<Vector3d, 3>& corners, int size) {
  const Vector3d& corner = corners[static_cast<std::size_t>(in_range(0, 2))];
  switch (in_range(0, 3)) {
    case 0: return corner;
    case 1: return (corner + corners[0]) / 2;
    default: return corner + integer_point(size);
  }
}

/// A radius, often the distance if that is a double.
double radius_near(const Triangle& triangle, const Vector3d& center, double size) {
  if (in_range(0, 3) == 0) return 0;
  if (in_range(0, 2) == 0) return in_range(0, 4) * size;
  const mpq_class squared = DegenerateTruth(triangle, rationals(center)).squared_distance;
  const double distance = std::sqrt(squared.get_d());
  const int doubles = in_range(-2, 2);
  return std::max(0.0, distance + doubles * (std::nextafter(distance, 2 * distance) - distance));
}

Triangle triangle_of_corners(const std::array<Vector3d, 3>& corners) { return {corners[0], corners[1], corners[2]}; }

DegenerateCase scaled(const DegenerateCase& c, int exponent) {
  const auto all = [exponent](const Vector3d& v) { return times_power(v, exponent); };
  return {{all(c.triangle.a), all(c.triangle.b), all(c.triangle.c)},
          Motion({all(c.motion.ball.center), std::ldexp(c.motion.ball.radius, exponent)}, all(c.motion.to))};
}

/// Everything is an integer of at most `size` and some; coordinates along the line are multiples of a small vector.
DegenerateCase draw_on_lattice(int size) {
  const Vector3d start = integer_point(size), step = integer_point(size);
  std::array<Vector3d, 3> corners;
  for (Vector3d& corner : corners) corner = start + in_range(-2, 2) * step;
  const Triangle triangle = triangle_of_corners(corners);
  const Vector3d center = start + in_range(-3, 3) * step + in_range(0, 1) * integer_point(3),
                 to = in_range(0, 5) == 0 ? center
                      : in_range(0, 1) == 0
                          ? Vector3d(center + in_range(-4, 4) * step + in_range(0, 1) * integer_point(2))
                          : center_near(corners, 4);
  return {triangle, Motion({center, static_cast<double>(in_range(0, 4))}, to)};
}

DegenerateCase draw_on_50_bits() {
  const auto large = [] { return Vector3d(integer_point(1 << 20) * 0x1p20 + integer_point(1 << 20)); };
  const Vector3d start = large(), step = large();
  std::array<Vector3d, 3> corners;
  for (Vector3d& corner : corners) corner = start + in_range(-20, 20) * step;
  const Triangle triangle = triangle_of_corners(corners);
  const Vector3d center = start + in_range(-25, 25) * step + in_range(0, 1) * large();
  const Vector3d to = start + in_range(-25, 25) * step + in_range(0, 1) * large();
  return {triangle, Motion({center, radius_near(triangle, center, 0x1p40)}, to)};
}

DegenerateCase draw_of_two_points() {
  const bool ordinary = in_range(0, 2) > 0;
  const auto draw = [ordinary] { return ordinary ? Vector3d(integer_point(1 << 24) / 7e5) : any_point(); };
  const std::array<Vector3d, 2> ends{draw(), draw()};
  std::array<Vector3d, 3> corners;
  for (Vector3d& corner : corners) corner = ends[static_cast<std::size_t>(in_range(0, 1))];
  const Triangle triangle = triangle_of_corners(corners);
  const Vector3d center = in_range(0, 3) == 0 ? corners[0] : draw(), to = in_range(0, 3) == 0 ? corners[1] : draw();
  double radius = radius_near(triangle, center, 10);
  if (!std::isfinite(radius)) radius = std::numeric_limits<double>::max();
  return {triangle, Motion({center, radius}, to)};
}

}  // namespace

void showValue(const DegenerateCase& drawn, std::ostream& out) {
  out.precision(std::numeric_limits<double>::max_digits10);
  const auto show = [&out](const char* name, const Vector3d& v) {
    out << name << " (" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  };
  show("triangle", drawn.triangle.a), show(",", drawn.triangle.b), show(",", drawn.triangle.c);
  show("; centre", drawn.motion.ball.center), show(" to", drawn.motion.to);
  out << ", radius " << drawn.motion.ball.radius;
}

rc::Gen<DegenerateCase> degenerate_lattice_cases() {
  return rc::gen::exec([] { return draw_on_lattice(in_range(1, 4)); });
}

rc::Gen<DegenerateCase> degenerate_cases() {
  return rc::gen::exec([] {
    switch (in_range(0, 4)) {
      case 0: return draw_on_lattice(in_range(1, 4));
      case 1: return scaled(draw_on_lattice(in_range(1, 4)), in_range(-1074, 1016));
      case 2: return draw_on_50_bits();
      case 3: return scaled(draw_on_50_bits(), in_range(-1074, 970));
      default: return draw_of_two_points();
    }
  });
}

DegenerateTruth::DegenerateTruth(const Triangle& triangle, const Rationals& center)
    : nearest{Feature::Kind::Vertex, 0}, squared_distance(-1) {
  const std::array<Rationals, 3> corners{rationals(triangle.a), rationals(triangle.b), rationals(triangle.c)};
  const auto consider = [&](const Feature& feature, const Rationals& at) {
    const Rationals way = minus(center, at);
    const mpq_class squared = dot(way, way);
    if (squared_distance >= 0 && squared >= squared_distance) return;
    nearest = feature, point = at, away = way, squared_distance = squared;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Rationals edge = minus(corners[(i + 1) % 3], corners[i]);
    const mpq_class along = dot(minus(center, corners[i]), edge), length = dot(edge, edge);
    if (along <= 0 || along >= length) continue;
    Rationals at = corners[i];
    for (std::size_t k = 0; k < 3; ++k) at[k] += along / length * edge[k];
    consider({Feature::Kind::Edge, i}, at);
  }
  for (std::size_t i = 0; i < 3; ++i) consider({Feature::Kind::Vertex, i}, corners[i]);
}

Rationals center_of(const Motion& motion, const mpq_class& time) {
  const Rationals from = rationals(motion.ball.center), way = minus(rationals(motion.to), from);
  return {from[0] + time * way[0], from[1] + time * way[1], from[2] + time * way[2]};
}

// The squared distance is convex on the way, and a parabola between the times at which the foot passes a corner. It is
// least at such a time, at the vertex of a parabola, or at an end.
mpq_class least_squared_distance(const Triangle& triangle, const Motion& motion, const mpq_class& begin,
                                 const mpq_class& end) {
  const Rationals from = rationals(motion.ball.center), way = minus(rationals(motion.to), from);
  const std::array<Rationals, 3> corners{rationals(triangle.a), rationals(triangle.b), rationals(triangle.c)};
  std::vector<mpq_class> times{begin, end};
  const auto root = [&](const mpq_class& constant, const mpq_class& slope) {
    if (slope == 0) return;
    const mpq_class time = -constant / slope;
    if (time > begin && time < end) times.push_back(time);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Rationals seen = minus(from, corners[i]);
    root(dot(seen, way), dot(way, way));
    for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3}) {
      const Rationals edge = minus(corners[j], corners[i]);
      root(dot(seen, edge), dot(way, edge));
      const Rationals moment = cross(edge, seen), change = cross(edge, way);
      root(dot(moment, change), dot(change, change));
    }
  }
  mpq_class least = -1;
  for (const mpq_class& time : times) {
    const mpq_class squared = DegenerateTruth(triangle, center_of(motion, time)).squared_distance;
    if (least < 0 || squared < least) least = squared;
  }
  return least;
}

}  // namespace touchstone::contact_tests

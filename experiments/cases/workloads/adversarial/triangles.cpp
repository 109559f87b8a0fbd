// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "experiments/cases/workloads/adversarial/shapes.h"
#include "experiments/cases/workloads/placement.h"
#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/detail/edge_sweep.h"

namespace touchstone::workloads::adversarial {
namespace {

using Eigen::Vector3d;

/// Draws a number in [-1, 1) with all bits of a double, even if it is small.
double any_bits(Random& random) { return 2 * random.unit() - 1; }

Vector3d any_point(Random& random) {
  const double x = any_bits(random), y = any_bits(random);
  return {x, y, any_bits(random)};
}

/// Draws a number of doubles: zero, few, or up to 2^40.
std::int64_t some_doubles(Random& random) {
  const std::int64_t most = std::int64_t{1} << random.integer(0, 40);
  return random.integer(-most, most);
}

Vector3d& vertex(Triangle& triangle, std::int64_t i) { return i == 0 ? triangle.a : i == 1 ? triangle.b : triangle.c; }

/// Integers with x^2 + y^2 + z^2 = length^2.
struct Quadruple {
  double x, y, z, length;
};

/// Draws a quadruple, with z = 0 for a triple.
Quadruple pythagorean(Random& random, bool triple) {
  double m[4];
  for (double& part : m) part = static_cast<double>(random.integer(-6, 6));
  const auto [a, b, c, d] = m;
  if (triple) return {a * a - b * b, 2 * a * b, 0, a * a + b * b};
  return {2 * (a * c + b * d), a * a + b * b - c * c - d * d, 2 * (b * c - a * d), a * a + b * b + c * c + d * d};
}

double integer(Random& random, std::int64_t most) { return static_cast<double>(random.integer(-most, most)); }

/// Draws a tangent in an integer frame. On the lattice the first edge runs along x from the origin, and the triangle
/// lies above it.
BallAndTriangle in_integer_frame(Random& random) {
  const std::int64_t most = std::int64_t{1} << random.integer(2, 20);
  const double distances[] = {0, 1, 0x1p10, 0x1p20};
  const workloads::Frame frame = workloads::lattice_frame(random, most, distances[random.integer(0, 3)]);
  const double end = static_cast<double>(random.integer(2, most)), x = integer(random, most);
  const double y = static_cast<double>(random.integer(1, most));
  const Triangle triangle{frame.at(0, 0, 0), frame.at(end, 0, 0), frame.at(x, y, 0)};

  const double scale = std::ldexp(1.0, static_cast<int>(random.integer(0, 12)));
  const double step = static_cast<double>(random.integer(0, static_cast<std::int64_t>(end)));
  switch (random.integer(0, 3)) {
    case 0: {  // above a point of the plane: on the first edge, level with the third vertex, or any
      const double level = random.coin() ? 0 : static_cast<double>(random.integer(0, static_cast<std::int64_t>(y)));
      const double h = integer(random, most);
      return {triangle, {frame.at(step, level, h), std::abs(h) * frame.unit}};
    }
    case 1: {  // off the first edge
      const Quadruple q = pythagorean(random, true);
      return {triangle, {frame.at(step, -scale * std::abs(q.x), scale * q.y), scale * q.length * frame.unit}};
    }
    case 2: {  // off the first vertex
      const Quadruple q = pythagorean(random, false);
      return {triangle,
              {frame.at(-scale * std::abs(q.x), -scale * std::abs(q.y), scale * q.z), scale * q.length * frame.unit}};
    }
    default: {  // off the third vertex
      const Quadruple q = pythagorean(random, false);
      return {triangle,
              {frame.at(x + scale * q.x, y + scale * std::abs(q.y), scale * q.z), scale * q.length * frame.unit}};
    }
  }
}

/// Draws a number with all its bits, of magnitude 2^-reach to 2^reach.
double number(Random& random, int reach) { return random.log_uniform(-reach, reach); }

/// Draws two vertices that differ in one coordinate, and a third that differs from them in two. The centre differs from
/// the plane, the first edge or the first vertex in one coordinate, by the radius.
BallAndTriangle along_axes(Random& random) {
  const auto i = static_cast<int>(random.integer(0, 2));
  const int j = (i + static_cast<int>(random.integer(1, 2))) % 3, k = 3 - i - j;
  const int reach = 1 << random.integer(0, 7);
  Triangle t{Vector3d::Zero(), {}, {}};
  t.a[i] = random.coin() ? 0 : number(random, reach);
  t.a[j] = random.coin() ? 0 : number(random, reach);
  t.b = t.c = t.a;
  t.b[i] += number(random, reach);
  t.c[i] += number(random, reach);
  t.c[j] += number(random, reach);

  const double radius = std::abs(number(random, reach)), share = random.unit();
  Vector3d center = t.a + share * (t.b - t.a);
  switch (random.integer(0, 2)) {
    case 0:  // above the face, or an edge
      if (random.coin()) center += random.unit() * (1 - share) * (t.c - t.a);
      center[k] = random.coin() ? radius : -radius;
      break;
    case 1:  // beside the first edge, away from the third vertex
      center[j] += t.c[j] > t.a[j] ? -radius : radius;
      break;
    default:  // beyond the first vertex
      center = t.a;
      center[i] += t.b[i] > t.a[i] ? -radius : radius;
  }
  return {t, {center, radius}};
}

}  // namespace

Triangle general_triangle(Random& random) {
  const Vector3d a = any_point(random), b = any_point(random);
  return {a, b, any_point(random)};
}

Triangle lattice_triangle(Random& random) {
  const std::int64_t most = std::int64_t{1} << random.integer(1, 26);
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
    for (double& x : vertex(triangle, i)) x = static_cast<double>(random.integer(-most, most));
  if (random.coin()) {  // in a coordinate plane
    const auto axis = static_cast<int>(random.integer(0, 2));
    triangle.b[axis] = triangle.c[axis] = triangle.a[axis];
  }
  if (random.coin()) {  // an edge along an axis
    const auto axis = static_cast<int>(random.integer(0, 2));
    const double end = triangle.b[axis];
    triangle.b = triangle.a;
    triangle.b[axis] = end;
  }
  return triangle;
}

Triangle needle_triangle(Random& random) {
  Triangle triangle = random.coin() ? general_triangle(random) : far_triangle(random);
  const double share = random.integer(0, 3) == 0 ? 0 : random.unit();
  triangle.c = triangle.a + share * (triangle.b - triangle.a);
  const auto axis = static_cast<int>(random.integer(0, 2));
  triangle.c[axis] = move_by_doubles(triangle.c[axis], some_doubles(random));
  if (random.coin()) std::swap(triangle.a, triangle.c);
  return triangle;
}

Triangle far_triangle(Random& random) {
  Triangle triangle = general_triangle(random);
  const Vector3d direction = any_point(random);
  const Vector3d origin = std::ldexp(1.0, static_cast<int>(random.integer(0, 50))) * direction;
  triangle.a += origin;
  triangle.b += origin;
  triangle.c += origin;
  return triangle;
}

double number_of_any_exponent(Random& random, int range) {
  constexpr int kLowest[kExponentRanges] = {-3, -60, -300, -1074, -1074, 900};
  constexpr int kHighest[kExponentRanges] = {30, 60, 300, 1022, -1000, 1022};
  const double number = random.log_uniform(kLowest[range], kHighest[range]);
  return random.coin() ? number : std::copysign(std::ldexp(1.0, std::ilogb(number)), number);
}

Triangle triangle_of_all_exponents(Random& random) {
  const auto range = static_cast<int>(random.integer(0, kExponentRanges - 1));
  Triangle triangle;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      double& x = vertex(triangle, i)[axis];
      switch (random.integer(0, 3)) {
        case 0: x = 0; break;
        case 1: x = i == 0 ? 0 : vertex(triangle, i - 1)[axis]; break;
        default: x = number_of_any_exponent(random, range);
      }
    }
  return triangle;
}

bool is_triangle(const Triangle& triangle) {
  const Vector3d u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  for (int k = 0; k < 3; ++k) {
    const double p = u[k] * v[(k + 1) % 3], q = u[(k + 1) % 3] * v[k];
    const double magnitude = std::abs(p) + std::abs(q);
    if (magnitude > 1e-200 && magnitude < 1e200 && std::abs(p - q) > 0x1p-45 * magnitude)
      return true;  // far beyond what rounding can do
  }
  try {
    return exact::detail::dropped_axis(Polygon({triangle.a, triangle.b, triangle.c})).has_value();
  } catch (const Rejected&) {
    return false;
  }
}

double size_of(const Triangle& triangle) {
  const Vector3d u = triangle.b - triangle.a, v = triangle.c - triangle.a;
  return std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
}

BallAndTriangle tangent(Random& random) { return random.coin() ? in_integer_frame(random) : along_axes(random); }

}  // namespace touchstone::workloads::adversarial

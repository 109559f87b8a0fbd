// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cases/workloads/adversarial/triangles.h"

#include <algorithm>
#include <cmath>

#include "experiments/cases/workloads/ulp.h"
#include "robust/exact/detail/dropped_axis.h"

namespace touchstone::adversarial {
namespace {

using Eigen::Vector3d;
using workloads::move_by_doubles;

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

}  // namespace touchstone::adversarial

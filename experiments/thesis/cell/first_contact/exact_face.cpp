// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/thesis/cell/first_contact/exact_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::kinematics {
namespace {

constexpr int kDigits = std::numeric_limits<double>::digits;

/// The nearest double above.
double rounded_up(const mpq_class& value, int unit) {
  const double near = std::ldexp(value.get_d(), unit);  // value.get_d() rounds towards 0
  return value == 0 ? 0 : std::nextafter(std::nextafter(near, HUGE_VAL), HUGE_VAL);
}

}  // namespace

int lowest_bit(const Eigen::Vector3d& v, int none) {
  int lowest = none;
  for (const double x : v) {
    if (x == 0) continue;
    int exponent = 0;
    const auto digits = static_cast<long>(std::ldexp(std::frexp(x, &exponent), kDigits));
    const mpz_class whole(digits);
    lowest = std::min(lowest, exponent - kDigits + static_cast<int>(mpz_scan1(whole.get_mpz_t(), 0)));
  }
  return lowest;
}

IntegerVector in_units(const Eigen::Vector3d& v, int unit) {
  IntegerVector result;
  for (int axis = 0; axis < 3; ++axis) {
    int exponent = 0;
    mpz_class whole(static_cast<long>(std::ldexp(std::frexp(v[axis], &exponent), kDigits)));
    const int shift = exponent - kDigits - unit;
    if (shift >= 0)
      whole <<= static_cast<mp_bitcnt_t>(shift);
    else
      whole >>= static_cast<mp_bitcnt_t>(-shift);  // zeros only
    result[static_cast<std::size_t>(axis)] = std::move(whole);
  }
  return result;
}

ExactFace::ExactFace(const Polygon& polygon, int unit) : scale(1), normal{0, 0, 0}, dropped_axis(0), off_plane(0) {
  for (std::size_t i = 0; i < polygon.vertex_count(); ++i) {
    vertices.push_back(in_units(polygon.vertex(i), unit));
    next.push_back(polygon.next(i));
  }
  const std::size_t outer = polygon.loop_end(0);
  IntegerVector sum{0, 0, 0};
  for (std::size_t i = 0; i < outer; ++i) {
    normal = normal + cross(vertices[i] - vertices[0], vertices[next[i]] - vertices[0]);
    sum = sum + vertices[i];
  }
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (mpz_cmpabs(normal[axis].get_mpz_t(), normal[dropped_axis].get_mpz_t()) > 0) dropped_axis = axis;

  // The heights over the supporting plane, through sum / outer, times outer and the normal's length.
  const mpz_class count(static_cast<unsigned long>(outer)), of_plane = dot(normal, sum);
  std::vector<mpz_class> heights;
  for (const IntegerVector& vertex : vertices) heights.push_back(mpz_class(count * dot(normal, vertex) - of_plane));
  if (std::ranges::all_of(heights, [](const mpz_class& height) { return height == 0; })) return;
  const bool negative = normal[dropped_axis] < 0;
  scale = abs(mpz_class(count * normal[dropped_axis]));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    off_plane = std::max(off_plane, rounded_up(mpq_class(abs(heights[i]), scale), unit));
    vertices[i] = scale * vertices[i];
    vertices[i][dropped_axis] += negative ? heights[i] : mpz_class(-heights[i]);
  }
}

}  // namespace touchstone::kinematics

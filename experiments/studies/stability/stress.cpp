// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/stability/stress.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace touchstone::stability {
namespace {

using filtered::detail::cross;
using filtered::detail::dot;

double root(const Rational& number) { return mpf_class(sqrt(real(number))).get_d(); }

RationalVector vertex(const Polygon& polygon, std::size_t i) { return exactly(polygon.vertex(i)); }

/// The square of the longest side of the box.
Rational box_side_squared(const Polygon& polygon) {
  mpq_class longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto coordinates = polygon.coordinates(axis);
    const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
    longest = std::max<mpq_class>(longest, mpq_class(*high) - mpq_class(*low));
  }
  return {mpq_class(longest * longest)};
}

}  // namespace

double aspect_ratio(const Polygon& polygon) {
  const std::size_t count = polygon.vertex_count();
  std::vector<RationalVector> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(vertex(polygon, i) - vertex(polygon, 0));
  RationalVector normal{exactly(0), exactly(0), exactly(0)};
  for (std::size_t i = 0; i < polygon.loop_end(0); ++i) normal = normal + cross(points[i], points[polygon.next(i)]);
  RationalVector longest{exactly(0), exactly(0), exactly(0)};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + 1; k < count; ++k) {
      const RationalVector between = points[k] - points[i];
      if (dot(between, between).value > dot(longest, longest).value) longest = between;
    }
  const RationalVector across = cross(normal, longest);
  mpq_class low = 0, high = 0;
  for (const RationalVector& point : points) {
    const mpq_class height = dot(across, point).value;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  // |D| over (high - low) / (|N| |D|), for |across| = |N| |D|.
  const Rational width{mpq_class(high - low)};
  const Rational length2 = dot(longest, longest);
  return root(length2 * length2 * dot(normal, normal) / (width * width));
}

double sine_at(const Polygon& polygon, std::size_t i) {
  const RationalVector a = vertex(polygon, polygon.previous(i)) - vertex(polygon, i);
  const RationalVector b = vertex(polygon, polygon.next(i)) - vertex(polygon, i);
  const RationalVector moment = cross(a, b);
  return root(dot(moment, moment) / (dot(a, a) * dot(b, b)));
}

double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second) {
  const RationalVector between = vertex(polygon, second) - vertex(polygon, first);
  return root(dot(between, between) / box_side_squared(polygon));
}

double relative_origin_distance(const Polygon& polygon) {
  const RationalVector first = vertex(polygon, 0);
  return root(dot(first, first) / box_side_squared(polygon));
}

int largest_exponent(const Polygon& polygon) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double x : polygon.coordinates(axis)) largest = std::max(largest, std::abs(x));
  return std::ilogb(largest);
}

}  // namespace touchstone::stability

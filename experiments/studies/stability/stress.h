// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Core>
#include <cstddef>

#include "geometry/shapes/polygon.h"
#include "robust/filtered/detail/numbers/vector3.h"

namespace touchstone::stability {

/// A rational number of GMP for use in generic expressions: gmpxx's own operators return expression templates, which
/// would refer to destroyed operands.
struct Rational {
  mpq_class value;

  friend Rational operator+(const Rational& a, const Rational& b) { return {mpq_class(a.value + b.value)}; }
  friend Rational operator-(const Rational& a, const Rational& b) { return {mpq_class(a.value - b.value)}; }
  friend Rational operator*(const Rational& a, const Rational& b) { return {mpq_class(a.value * b.value)}; }
  friend Rational operator/(const Rational& a, const Rational& b) { return {mpq_class(a.value / b.value)}; }
};

using RationalVector = filtered::detail::Vector3<Rational>;

inline Rational exactly(double x) { return {mpq_class(x)}; }
inline RationalVector exactly(const Eigen::Vector3d& v) { return {exactly(v.x()), exactly(v.y()), exactly(v.z())}; }
inline RationalVector operator+(const RationalVector& a, const RationalVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Converts to a number with 512 bits and any exponent.
inline mpf_class real(const Rational& number) { return {number.value, 512}; }

// The actual stress of a polygon of doubles, computed in rationals and finally rounded to a relative 1e-15 or so. It
// verifies that a scene has the stress of its level.

/// Returns the distance of the two farthest vertices divided by the width perpendicular to their connection, in the
/// supporting plane of the first loop: for a triangle, its longest side over the height on it; for a square, 1.
/// Requires a normal. Cost: quadratic.
[[nodiscard]] double aspect_ratio(const Polygon& polygon);

/// Returns the sine of the angle between the lines of the two edges that meet at a vertex.
[[nodiscard]] double sine_at(const Polygon& polygon, std::size_t vertex);

/// Returns the distance of two vertices divided by the longest side of the polygon's box.
[[nodiscard]] double relative_distance(const Polygon& polygon, std::size_t first, std::size_t second);

/// Returns the distance of vertex 0 from the origin divided by the longest side of the polygon's box.
[[nodiscard]] double relative_origin_distance(const Polygon& polygon);

/// Returns the exponent of the largest coordinate.
[[nodiscard]] int largest_exponent(const Polygon& polygon);

}  // namespace touchstone::stability

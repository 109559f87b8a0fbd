// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Core>

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

}  // namespace touchstone::stability

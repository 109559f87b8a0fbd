// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robust/detail/exact_kernel.h"
#include "robust/exact/detail/nearest_double.h"

/// Doubles nearest to what roots are part of, in the sense of nearest_double.h. `Number` is exact and has no division.
namespace touchstone::exact::detail {

/// Returns (term + sign sqrt(radicand)) / denominator. Requires radicand >= 0 and denominator > 0.
template <class Number>
double rounded_sum_with_root(const Number& term, int sign, const Number& radicand, const Number& denominator) {
  const Rational sum = rational(term), square = rational(radicand), divisor = rational(denominator);
  // Everything times the denominators, so that integers remain.
  const Integer scale = denominator_of(sum) * denominator_of(square);
  const Integer root_scale = scale * denominator_of(divisor);
  return nearest_sum_with_root(Integer(numerator_of(sum) * denominator_of(square) * denominator_of(divisor)), sign,
                               Integer(numerator_of(square) * root_scale * (root_scale / denominator_of(square))),
                               Integer(numerator_of(divisor) * scale));
}

/// Returns the radius less the distance, of which the square is numerator / denominator. All lengths are multiplied by
/// `scale`. Requires denominator > 0 and scale > 0.
template <class Number>
double rounded_depth(const Number& radius, const Number& numerator, const Number& denominator, const Number& scale) {
  return rounded_sum_with_root(Number(radius * denominator), -1, Number(numerator * denominator),
                               Number(denominator * scale));
}

/// Returns the vector divided by its length; zero for the vector zero.
template <class Number>
Eigen::Vector3d rounded_unit_vector(const Number& x, const Number& y, const Number& z) {
  const Number length_squared = kernel::square(x) + kernel::square(y) + kernel::square(z);
  if (kernel::is_zero(length_squared)) return Eigen::Vector3d::Zero();
  const auto component = [&length_squared](const Number& of) {
    const double size = rounded(Number(kernel::square(of)), length_squared, nearest_root);
    return kernel::is_negative(of) ? 0.0 - size : size;  // never -0
  };
  return {component(x), component(y), component(z)};
}

}  // namespace touchstone::exact::detail

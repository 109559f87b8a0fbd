// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/smaller_root.h"

#include <cassert>
#include <utility>

#include "robust/exact/detail/rounded_roots.h"

namespace touchstone::exact::detail {
namespace {

/// Returns the sign of x + y sqrt(d). Requires d >= 0.
kernel::Sign sign_of_sum(const Number& x, const Number& y, const Number& d) {
  const kernel::Sign x_sign = kernel::sign(x), root_sign = kernel::is_zero(d) ? kernel::ZERO : kernel::sign(y);
  if (root_sign == kernel::ZERO || x_sign == root_sign) return x_sign;
  if (x_sign == kernel::ZERO) return root_sign;
  return x_sign * kernel::compare(kernel::square(x), kernel::square(y) * d);
}

/// Returns the sign of x + y sqrt(d) - z sqrt(e). Requires y, z > 0 and d, e >= 0.
kernel::Sign sign_of_sum(const Number& x, const Number& y, const Number& d, const Number& z, const Number& e) {
  const Number plus = kernel::square(y) * d, minus = kernel::square(z) * e;
  const kernel::Sign x_sign = kernel::sign(x), roots_sign = kernel::compare(plus, minus);
  if (roots_sign == kernel::ZERO || x_sign == roots_sign) return x_sign;
  if (x_sign == kernel::ZERO) return roots_sign;
  // The square of the roots' sum is plus + minus - 2 y z sqrt(d e).
  return x_sign * sign_of_sum(kernel::square(x) - plus - minus, 2 * y * z, d * e);
}

}  // namespace

SmallerRoot::SmallerRoot(const Quadratic& quadratic, Number discriminant)
    : a_(quadratic.a), b_(quadratic.b), discriminant_(std::move(discriminant)) {}

std::optional<SmallerRoot> SmallerRoot::within_unit_interval(const Quadratic& quadratic) {
  const auto& [a, b, c] = quadratic;
  assert(!kernel::is_negative(a));
  if (kernel::is_zero(a) || !kernel::is_negative(b) || !kernel::is_positive(c)) return std::nullopt;
  Number discriminant = kernel::square(b) - a * c;
  if (kernel::is_negative(discriminant)) return std::nullopt;
  // Both roots are positive. The smaller one is at most 1 if the vertex of the parabola is, or the value at 1.
  if (kernel::is_negative(a + b) && kernel::is_positive(a + 2 * b + c)) return std::nullopt;
  return SmallerRoot(quadratic, std::move(discriminant));
}

kernel::Sign SmallerRoot::sign_of(const Linear& function) const {
  return sign_of_sum(a_ * function.p - b_ * function.q, -function.q, discriminant_);
}

double SmallerRoot::rounded(const Linear& function, const Number& divisor) const {
  return rounded_sum_with_root(Number(a_ * function.p - b_ * function.q), -static_cast<int>(kernel::sign(function.q)),
                               Number(kernel::square(function.q) * discriminant_), Number(a_ * divisor));
}

kernel::Comparison_result compare(const SmallerRoot& first, const SmallerRoot& second) {
  return sign_of_sum(second.b_ * first.a_ - first.b_ * second.a_, first.a_, second.discriminant_, second.a_,
                     first.discriminant_);
}

}  // namespace touchstone::exact::detail

// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/smaller_root.h"

#include <cassert>
#include <utility>

#include "robust/exact/detail/nearest_double.h"

namespace touchstone::exact {
namespace {

/// Returns the sign of x + y sqrt(d). Requires d >= 0.
CGAL::Sign sign_of_sum(const Number& x, const Number& y, const Number& d) {
  const CGAL::Sign x_sign = CGAL::sign(x), root_sign = CGAL::is_zero(d) ? CGAL::ZERO : CGAL::sign(y);
  if (root_sign == CGAL::ZERO || x_sign == root_sign) return x_sign;
  if (x_sign == CGAL::ZERO) return root_sign;
  return x_sign * CGAL::compare(CGAL::square(x), CGAL::square(y) * d);
}

/// Returns the sign of x + y sqrt(d) - z sqrt(e). Requires y, z > 0 and d, e >= 0.
CGAL::Sign sign_of_sum(const Number& x, const Number& y, const Number& d, const Number& z, const Number& e) {
  const Number plus = CGAL::square(y) * d, minus = CGAL::square(z) * e;
  const CGAL::Sign x_sign = CGAL::sign(x), roots_sign = CGAL::compare(plus, minus);
  if (roots_sign == CGAL::ZERO || x_sign == roots_sign) return x_sign;
  if (x_sign == CGAL::ZERO) return roots_sign;
  // The square of the roots' sum is plus + minus - 2 y z sqrt(d e).
  return x_sign * sign_of_sum(CGAL::square(x) - plus - minus, 2 * y * z, d * e);
}

}  // namespace

SmallerRoot::SmallerRoot(const Quadratic& quadratic, Number discriminant)
    : a_(quadratic.a), b_(quadratic.b), discriminant_(std::move(discriminant)) {}

std::optional<SmallerRoot> SmallerRoot::within_unit_interval(const Quadratic& quadratic) {
  const auto& [a, b, c] = quadratic;
  assert(!CGAL::is_negative(a));
  if (CGAL::is_zero(a) || !CGAL::is_negative(b) || !CGAL::is_positive(c)) return std::nullopt;
  Number discriminant = CGAL::square(b) - a * c;
  if (CGAL::is_negative(discriminant)) return std::nullopt;
  // Both roots are positive. The smaller one is at most 1 if the vertex of the parabola is, or the value at 1.
  if (CGAL::is_negative(a + b) && CGAL::is_positive(a + 2 * b + c)) return std::nullopt;
  return SmallerRoot(quadratic, std::move(discriminant));
}

CGAL::Sign SmallerRoot::sign_of(const Linear& function) const {
  return sign_of_sum(a_ * function.p - b_ * function.q, -function.q, discriminant_);
}

double SmallerRoot::rounded(const Linear& function, const Number& divisor) const {
  const mpq_class sum = rational(Number(a_ * function.p - b_ * function.q)),
                  radicand = rational(Number(CGAL::square(function.q) * discriminant_)),
                  denominator = rational(Number(a_ * divisor));
  // Everything times the denominators, so that integers remain.
  const mpz_class scale = sum.get_den() * radicand.get_den();
  const mpz_class root_scale = scale * denominator.get_den();
  return nearest_sum_with_root(sum.get_num() * radicand.get_den() * denominator.get_den(),
                               -static_cast<int>(CGAL::sign(function.q)),
                               mpz_class(radicand.get_num() * root_scale * (root_scale / radicand.get_den())),
                               mpz_class(denominator.get_num() * scale));
}

CGAL::Comparison_result compare(const SmallerRoot& first, const SmallerRoot& second) {
  return sign_of_sum(second.b_ * first.a_ - first.b_ * second.a_, first.a_, second.discriminant_, second.a_,
                     first.discriminant_);
}

}  // namespace touchstone::exact

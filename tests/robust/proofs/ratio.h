// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/robust/proofs/rationals.h"

namespace touchstone::proofs {

/// A computed number that is not negative, by its ratio to the same expression without rounding, in which factors that
/// nearly are 1, such as kWide, are 1. Every operation has a relative error of at most 2^-bits.
template <int bits>
struct Ratio {
  mpq_class least = 1, most = 1;

  Ratio() = default;
  Ratio(mpq_class low, mpq_class high) : least(std::move(low)), most(std::move(high)) {}
  explicit Ratio(int) {}  // for Eigen's sum of no numbers, which nothing asks for

  static Ratio all(double constant) { return std::abs(constant - 1) < 0x1p-30 ? Ratio{constant, constant} : Ratio{}; }
  [[nodiscard]] Ratio rounded() const {
    const mpq_class unit = power(mpq_class(1, 2), bits);
    return {least * (1 - unit), most * (1 + unit)};
  }

  friend Ratio maximum(const Ratio& a, const Ratio& b) {
    return {std::min(a.least, b.least), std::max(a.most, b.most)};
  }
  friend Ratio operator+(const Ratio& a, const Ratio& b) { return maximum(a, b).rounded(); }
  friend Ratio operator*(const Ratio& a, const Ratio& b) { return Ratio{a.least * b.least, a.most * b.most}.rounded(); }
  friend Ratio quotient(const Ratio& a, const Ratio& b) {
    return Ratio{a.least / b.most, b.least > 0 ? mpq_class(a.most / b.least) : power(2, 5000)}.rounded();
  }
  friend Ratio operator/(const Ratio& a, const Ratio& b) { return quotient(a, b); }
  friend Ratio square_root(const Ratio& a) { return Ratio{root_below(a.least), root_above(a.most)}.rounded(); }
  /// p A - q B <= p (A - B) if p <= q. So a difference has a bound on the side on which its operands allow this.
  friend Ratio operator-(const Ratio& a, const Ratio& b) {
    const mpq_class any = power(2, 5000);
    return Ratio{b.most <= a.least ? a.least : mpq_class(0), a.most <= b.least ? a.most : any}.rounded();
  }
};

}  // namespace touchstone::proofs

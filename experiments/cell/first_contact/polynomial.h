// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

/// Real roots of polynomials with integer coefficients, exactly.
namespace touchstone::kinematics {

/// The number numerator / 2^shift.
struct Dyadic {
  mpz_class numerator;
  unsigned shift = 0;
};

/// coefficients[i] belongs to x^i; the last is not 0. No coefficient: the polynomial 0.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<mpz_class> coefficients);

  [[nodiscard]] const std::vector<mpz_class>& coefficients() const { return coefficients_; }
  [[nodiscard]] bool zero() const { return coefficients_.empty(); }
  /// -1 for the polynomial 0.
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// The value times 2^(degree x.shift). Requires a polynomial other than 0.
  [[nodiscard]] mpz_class scaled_value_at(const Dyadic& x) const;
  [[nodiscard]] int sign_at(const Dyadic& x) const { return zero() ? 0 : sgn(scaled_value_at(x)); }

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const mpz_class& a, const Polynomial& b);

 private:
  std::vector<mpz_class> coefficients_;
};

/// The greatest common divisor, up to a factor. Requires that one of them is not 0.
[[nodiscard]] Polynomial common_divisor(const Polynomial& a, const Polynomial& b);

/// Counts the roots of a polynomial without multiple roots, by Sturm's theorem.
class Sturm {
 public:
  explicit Sturm(const Polynomial& square_free);
  /// The number of roots in (low, high].
  [[nodiscard]] int roots(const Dyadic& low, const Dyadic& high) const { return changes(low) - changes(high); }

 private:
  [[nodiscard]] int changes(const Dyadic& x) const;
  std::vector<Polynomial> chain_;
};

/// A real root, in (low, high], or equal to both; the only one there of a polynomial without multiple roots.
class Root {
 public:
  [[nodiscard]] const Dyadic& low() const { return low_; }
  [[nodiscard]] const Dyadic& high() const { return high_; }
  [[nodiscard]] bool multiple() const { return multiple_; }  ///< of the polynomial that was asked about

  /// Halves what holds the root until it is at most 2^-bits wide.
  void refine(unsigned bits);
  /// The sign of a polynomial at the root: exact. Refines the root as far as it takes.
  [[nodiscard]] int sign_of(const Polynomial& polynomial);

 private:
  friend class RootFinder;
  Polynomial square_free_;  // without multiple roots in (low_, high_]
  Dyadic low_, high_;
  int sign_above_ = 0;  // of square_free_ between the root and high_, and there
  bool multiple_ = false;
};

/// The different roots in (0, end], ascending, each once. None of the polynomial 0. Requires end > 0.
///
/// Where Descartes's rule of signs in the Bernstein basis isolates them after some halvings, that is all; multiple
/// roots, and those at ends of intervals, are isolated by Sturm's theorem. Cost: some microseconds for degree 4 and
/// coefficients of 1000 bits, some hundreds by Sturm's theorem. Source: [basu2006, ch. 10].
[[nodiscard]] std::vector<Root> real_roots(const Polynomial& polynomial, const Dyadic& end);

}  // namespace touchstone::kinematics

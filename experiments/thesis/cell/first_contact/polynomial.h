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

/// A polynomial with integer coefficients: coefficients[i] belongs to x^i; the last is not 0. The polynomial 0 has
/// none.
class Polynomial {
 public:
  Polynomial() = default;
  explicit Polynomial(std::vector<mpz_class> coefficients);

  [[nodiscard]] const std::vector<mpz_class>& coefficients() const { return coefficients_; }
  [[nodiscard]] bool zero() const { return coefficients_.empty(); }
  /// Returns the degree; -1 for the polynomial 0.
  [[nodiscard]] int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// Returns the value times 2^(degree x.shift). Requires a polynomial other than 0.
  [[nodiscard]] mpz_class scaled_value_at(const Dyadic& x) const;
  [[nodiscard]] int sign_at(const Dyadic& x) const { return zero() ? 0 : sgn(scaled_value_at(x)); }

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const mpz_class& a, const Polynomial& b);

 private:
  std::vector<mpz_class> coefficients_;
};

/// Returns the greatest common divisor, up to a factor. Requires that one of the polynomials is not 0.
[[nodiscard]] Polynomial common_divisor(const Polynomial& a, const Polynomial& b);

/// Counts the roots of a polynomial without multiple roots, by Sturm's theorem.
class Sturm {
 public:
  explicit Sturm(const Polynomial& square_free);
  /// Returns the number of roots in (low, high].
  [[nodiscard]] int roots(const Dyadic& low, const Dyadic& high) const { return changes(low) - changes(high); }

 private:
  [[nodiscard]] int changes(const Dyadic& x) const;
  std::vector<Polynomial> chain_;
};

/// A real root, in (low, high], or equal to both; the only root of a square-free polynomial there.
class Root {
 public:
  [[nodiscard]] const Dyadic& low() const { return low_; }
  [[nodiscard]] const Dyadic& high() const { return high_; }
  [[nodiscard]] bool multiple() const { return multiple_; }  ///< in the polynomial given to real_roots

  /// Halves the interval of the root until it is at most 2^-bits wide.
  void refine(unsigned bits);
  /// Returns the exact sign of a polynomial at the root. Refines the root as far as needed.
  [[nodiscard]] int sign_of(const Polynomial& polynomial);

 private:
  friend class RootFinder;
  Polynomial square_free_;  // without multiple roots in (low_, high_]
  Dyadic low_, high_;
  int sign_above_ = 0;  // of square_free_ between the root and high_, and there
  bool multiple_ = false;
};

/// Returns the distinct roots in (0, end], ascending. The polynomial 0 has none. Requires end > 0.
///
/// Isolates roots by Descartes's rule of signs in the Bernstein basis and a few halvings. Where that fails, for
/// multiple roots and roots at ends of intervals, uses Sturm's theorem. Cost: some microseconds for degree 4 and
/// coefficients of 1000 bits, some hundreds with Sturm's theorem. Source: [basu2006, ch. 10].
[[nodiscard]] std::vector<Root> real_roots(const Polynomial& polynomial, const Dyadic& end);

}  // namespace touchstone::kinematics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "experiments/thesis/cell/first_contact/polynomial.h"

namespace touchstone::kinematics {

/// Vectors of integers, or of polynomials.
template <class T>
using Vector = std::array<T, 3>;
using IntegerVector = Vector<mpz_class>;
using PolynomialVector = Vector<Polynomial>;

inline IntegerVector operator+(const IntegerVector& a, const IntegerVector& b) {
  return {mpz_class(a[0] + b[0]), mpz_class(a[1] + b[1]), mpz_class(a[2] + b[2])};
}
inline IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) {
  return {mpz_class(a[0] - b[0]), mpz_class(a[1] - b[1]), mpz_class(a[2] - b[2])};
}
inline IntegerVector operator*(const mpz_class& s, const IntegerVector& a) {
  return {mpz_class(s * a[0]), mpz_class(s * a[1]), mpz_class(s * a[2])};
}
inline PolynomialVector operator+(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline PolynomialVector operator-(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// Returns the polynomial p times the direction a.
inline PolynomialVector operator*(const Polynomial& p, const IntegerVector& a) {
  return {a[0] * p, a[1] * p, a[2] * p};
}

inline mpz_class dot(const IntegerVector& a, const IntegerVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Polynomial dot(const IntegerVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Polynomial squared(const PolynomialVector& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }
inline IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {mpz_class(a[1] * b[2] - a[2] * b[1]), mpz_class(a[2] * b[0] - a[0] * b[2]),
          mpz_class(a[0] * b[1] - a[1] * b[0])};
}
inline PolynomialVector cross(const PolynomialVector& a, const IntegerVector& b) {
  return {b[2] * a[1] - b[1] * a[2], b[0] * a[2] - b[2] * a[0], b[1] * a[0] - b[0] * a[1]};
}

/// Returns all vectors times the least power of two that makes all of them integers. Requires denominators that are
/// powers of two.
[[nodiscard]] std::vector<IntegerVector> whole(const std::vector<Vector<mpq_class>>& vectors);

/// The angles of a turn as points of a projective line: tan(phi / 2) = |axis| y / x, so that a turn is that of the
/// quaternion (x, y axis), whose matrix is rational in x and y. Three charts give x and y as linear functions of a
/// parameter w, and cover the turn once, in the order of the angle:
///   chart 0: (2^k, w), 0 <= w <= 1; chart 1: (2^k (1 - w), 1), 0 <= w <= 2; chart 2: (-2^k, 1 - w), 0 <= w <= 1,
/// with 2^k about as large as |axis|.
class Charts {
 public:
  /// Requires an axis that is not 0.
  explicit Charts(const Eigen::Vector3d& axis);

  static constexpr int kCount = 3;
  [[nodiscard]] const IntegerVector& axis() const { return axis_; }  ///< up to a positive factor

  /// x and y as functions of w, and the last w.
  struct Chart {
    Polynomial x, y;
    Dyadic end;
  };
  [[nodiscard]] Chart chart(int number) const;

  /// Returns where a chart begins (and the one before it ends), in degrees, up to rounding.
  [[nodiscard]] double begin(int number) const;

  enum class Towards { Low, High };
  /// Returns the angle in degrees as a double on the given side of it, adjacent to it or nearly so. Cost: about 10 us.
  [[nodiscard]] double degrees(int chart, const Dyadic& w, Towards side) const;
  /// Returns whether the angle is greater, as far as a precision of `bits` bits can tell.
  [[nodiscard]] bool degrees_exceed(int chart, const Dyadic& w, double degrees, long bits) const;

 private:
  template <class F>
  void with_angle(int chart, const Dyadic& w, Towards side, long bits, const F& f) const;

  IntegerVector axis_;
  mpz_class squared_length_;
  unsigned exponent_;  // k
};

/// An angle, as a root in a chart.
struct Moment {
  int chart;
  Root root;
};

/// Compares two angles: returns -1, 0 or 1; 0 also for angles whose parameters differ by less than 2^-120.
[[nodiscard]] int compare(Moment& a, Moment& b);

}  // namespace touchstone::kinematics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>

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

}  // namespace touchstone::kinematics

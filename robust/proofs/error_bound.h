// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <iterator>

/// The error calculus in rationals: a number type whose operations carry the bounds that bounds.h's model gives.
namespace touchstone::filtered::proofs {

/// Every operation returns its exact result times (1 + d), |d| <= unit, plus at most `underflow` in magnitude.
struct ErrorModel {
  mpq_class unit, underflow;
  /// A number times itself is known to be positive. Without that, all bounds are polynomials in the inputs' maxima and
  /// errors, with coefficients that are not negative.
  bool knows_squares;
};

/// All that is known of a number: its computed value lies in [low, high] and differs from the exact one by at most
/// `error`.
struct ErrorBound {
  const ErrorModel* model;
  mpq_class low, high, error;

  [[nodiscard]] mpq_class magnitude() const { return std::max<mpq_class>(abs(low), abs(high)); }
};

inline ErrorBound known_within(const ErrorModel& model, const mpq_class& magnitude, const mpq_class& error) {
  return {&model, -magnitude, magnitude, error};
}

/// The bound of a result that would lie in [low, high] with at most `error` if the operation were exact.
inline ErrorBound rounded(const ErrorModel* model, const mpq_class& low, const mpq_class& high,
                          const mpq_class& error) {
  const mpq_class below = model->unit * abs(low) + model->underflow;
  const mpq_class above = model->unit * abs(high) + model->underflow;
  return {model, low - below, high + above, error + std::max(below, above)};
}

inline ErrorBound operator+(const ErrorBound& a, const ErrorBound& b) {
  return rounded(a.model, a.low + b.low, a.high + b.high, a.error + b.error);
}
inline ErrorBound operator-(const ErrorBound& a, const ErrorBound& b) {
  return rounded(a.model, a.low - b.high, a.high - b.low, a.error + b.error);
}

/// a b - A B = a (b - B) + (a - A) B, and |B| <= |b| + |b - B|.
inline ErrorBound operator*(const ErrorBound& a, const ErrorBound& b) {
  const mpq_class corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const bool is_square = a.model->knows_squares && &a == &b;
  const mpq_class low = is_square ? mpq_class(0) : *std::min_element(std::begin(corners), std::end(corners));
  const mpq_class high = *std::max_element(std::begin(corners), std::end(corners));
  return rounded(a.model, low, high, a.magnitude() * b.error + a.error * (b.magnitude() + b.error));
}

/// The larger of two, and a magnitude: neither is rounded.
inline ErrorBound maximum(const ErrorBound& a, const ErrorBound& b) {
  return {a.model, std::max(a.low, b.low), std::max(a.high, b.high), std::max(a.error, b.error)};
}
inline ErrorBound magnitude(const ErrorBound& a) { return {a.model, 0, a.magnitude(), a.error}; }

}  // namespace touchstone::filtered::proofs

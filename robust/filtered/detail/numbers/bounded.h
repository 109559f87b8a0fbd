// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/lanes.h"
#include "robust/filtered/detail/signs/bounds.h"

/// Numbers that carry a bound of their error through any expression: doubles in lanes and double-doubles.
///
/// Guarantee: after k operations a computed value differs from the exact one by at most (1 + 8 u)^k times its `error`,
/// u = 2^-52. The factor is that of the roundings of the error itself, of which no operation makes more than eight;
/// `positive` and `negative` allow for 2^12 operations, divisors for half as many. Lanes are valid in every rounding
/// direction and under flush-to-zero, double-doubles in round to nearest.
///
/// Requires lengths of at most bounds::kLongestMotion, and vectors whose maximum is at least the inverse of that. Then
/// nothing overflows in expressions of degree 8, and the error of every expression of vectors exceeds the effect of
/// underflow by far. That need not be so for products of single exact numbers.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

/// The type of errors, the errors of operations in units of relative rounding, and a number below all divisors
/// that are certainly positive: their errors are larger.
template <class Number>
struct ErrorTraits;
template <>
struct ErrorTraits<Pack> {
  using Error = Pack;
  static constexpr double unit = bounds::kUnit;
  static constexpr double dot = bounds::kRoundedDot, cross = bounds::kRoundedCross, quotient = 1;
  static constexpr double least_divisor = 0x1p-300;
};
template <>
struct ErrorTraits<DoubleDouble> {
  using Error = double;
  static constexpr double unit = bounds::kDoubleDoubleUnit;
  static constexpr double dot = bounds::kDot, cross = bounds::kCross, quotient = bounds::kQuotient;
  static constexpr double least_divisor = 0x1p-900;
};
template <class Number>
using ErrorOf = typename ErrorTraits<Number>::Error;

/// @{
/// The operations of lanes for single numbers. Truth values are bits of lanes, here of one.
TOUCHSTONE_INLINE double magnitude(const DoubleDouble& a) { return std::abs(a.high); }
TOUCHSTONE_INLINE unsigned below(double a, double b) { return a < b ? 1U : 0U; }
TOUCHSTONE_INLINE unsigned below(const Pack& a, const Pack& b) { return negative_lanes(a - b); }
TOUCHSTONE_INLINE Pack leading(const Pack& a) { return a; }
TOUCHSTONE_INLINE Pack magnitude_of(const Pack& a) { return magnitude(a); }
TOUCHSTONE_INLINE DoubleDouble magnitude_of(const DoubleDouble& a) { return a.high < 0 ? -a : a; }
TOUCHSTONE_INLINE DoubleDouble square_root(const DoubleDouble& a) { return sqrt(a); }
TOUCHSTONE_INLINE Pack quotient(const Pack& a, const Pack& b) { return a / b; }
TOUCHSTONE_INLINE double quotient(double a, double b) { return a / b; }
TOUCHSTONE_INLINE DoubleDouble quotient(const DoubleDouble& a, const DoubleDouble& b) { return a / b; }
TOUCHSTONE_INLINE Pack at_least(const Pack& a, const Pack& least) { return maximum(a, least); }
TOUCHSTONE_INLINE DoubleDouble at_least(const DoubleDouble& a, double least) {
  return a.high < least ? DoubleDouble(least) : a;
}
/// @}

/// A number and a bound of its error.
template <class Number>
struct Bounded {
  Number value;
  ErrorOf<Number> error;
};

/// Returns the error of rounding a result, `units` of its size.
template <class Number>
TOUCHSTONE_INLINE ErrorOf<Number> rounding(const Number& result, double units = 1) {
  return constant<ErrorOf<Number>>(units * ErrorTraits<Number>::unit) * magnitude(result);
}

template <class Number>
TOUCHSTONE_INLINE Bounded<Number> operator+(const Bounded<Number>& a, const Bounded<Number>& b) {
  const Number value = a.value + b.value;
  return {value, (a.error + b.error) + rounding(value)};
}
template <class Number>
TOUCHSTONE_INLINE Bounded<Number> operator-(const Bounded<Number>& a, const Bounded<Number>& b) {
  const Number value = a.value - b.value;
  return {value, (a.error + b.error) + rounding(value)};
}
template <class Number>
TOUCHSTONE_INLINE Bounded<Number> operator*(const Bounded<Number>& a, const Bounded<Number>& b) {
  const Number value = a.value * b.value;
  return {value, (magnitude(a.value) * b.error + a.error * (magnitude(b.value) + b.error)) + rounding(value)};
}
template <class Number>
TOUCHSTONE_INLINE Bounded<Number> square(const Bounded<Number>& a) {
  return a * a;
}

/// Returns the lanes in which the number is certainly positive, or certainly negative.
template <class Number>
TOUCHSTONE_INLINE unsigned positive(const Bounded<Number>& a) {
  return below(constant<ErrorOf<Number>>(bounds::kWideError) * a.error, leading(a.value));
}
template <class Number>
TOUCHSTONE_INLINE unsigned negative(const Bounded<Number>& a) {
  const ErrorOf<Number> zero = constant<ErrorOf<Number>>(0);
  return below(leading(a.value), zero - constant<ErrorOf<Number>>(bounds::kWideError) * a.error);
}

/// Returns the number, or its error if that is larger: a number that is certainly positive stays as it is, and others
/// become small positive numbers, so that divisions and roots raise no flag.
template <class Number>
TOUCHSTONE_INLINE Number at_least_error(const Bounded<Number>& a) {
  return at_least(a.value, a.error);
}

/// Returns a / b where b is certainly positive; other lanes hold any finite number with a large error.
template <class Number>
TOUCHSTONE_INLINE Bounded<Number> quotient(const Bounded<Number>& a, const Bounded<Number>& b) {
  using Error = ErrorOf<Number>;
  const Error certain = maximum(leading(b.value) - constant<Error>(bounds::kWideError) * b.error,
                                constant<Error>(ErrorTraits<Number>::least_divisor));
  const Number value = quotient(a.value, at_least_error(b));
  return {value,
          quotient(a.error + magnitude(value) * b.error, certain) + rounding(value, ErrorTraits<Number>::quotient)};
}

/// Returns the root of a number that is not negative. If x > 0 and y >= 0 differ by e, their roots differ by at most
/// e / sqrt(x); and x may be replaced by e, if that is larger. Other lanes hold any finite number.
template <class Number>
TOUCHSTONE_INLINE Bounded<Number> root(const Bounded<Number>& a) {
  const Number value = square_root(at_least_error(a));
  return {value, quotient(a.error, leading(value)) + rounding(value, ErrorTraits<Number>::quotient)};
}

TOUCHSTONE_INLINE double largest_component(const Vector3<DoubleDouble>& v) {
  return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}

/// A vector of which each component has at most this magnitude and this error. The error is positive, or 0 if exact.
template <class Number>
struct BoundedVector {
  Vector3<Number> value;
  ErrorOf<Number> maximum, error;
};

/// Returns `count` times the error of a product of components, plus `units` roundings of it.
template <class Number>
TOUCHSTONE_INLINE ErrorOf<Number> error_of_products(const BoundedVector<Number>& a, const BoundedVector<Number>& b,
                                                    double count, double units) {
  using Error = ErrorOf<Number>;
  const Error propagated = a.maximum * b.error + a.error * (b.maximum + b.error);
  return constant<Error>(count) * propagated +
         constant<Error>(units * ErrorTraits<Number>::unit) * (a.maximum * b.maximum);
}

template <class Number>
TOUCHSTONE_INLINE Bounded<Number> dot(const BoundedVector<Number>& a, const BoundedVector<Number>& b) {
  return {dot(a.value, b.value), error_of_products(a, b, 3, ErrorTraits<Number>::dot)};
}
template <class Number>
TOUCHSTONE_INLINE BoundedVector<Number> cross(const BoundedVector<Number>& a, const BoundedVector<Number>& b) {
  const Vector3<Number> value = cross(a.value, b.value);
  return {
      {value.x, value.y, value.z}, largest_component(value), error_of_products(a, b, 2, ErrorTraits<Number>::cross)};
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "robust/detail/integers.h"

/// The kernel of exact arithmetic: numbers that are integers times powers of two, vectors of them, and their signs. It
/// is CGAL's, or, with TOUCHSTONE_EXACT=OFF, one over Boost.Multiprecision that has the few functions that are used, by
/// the names that they have in CGAL.
#if defined(TOUCHSTONE_BOOST_NUMBERS)
#include <algorithm>
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>

/// A stand-in for CGAL's kernel Simple_cartesian<Mpzf>, by the same names: see CGAL's manual.
namespace touchstone::kernel_of_boost {

enum Sign { NEGATIVE = -1, ZERO = 0, POSITIVE = 1, SMALLER = NEGATIVE, EQUAL = ZERO, LARGER = POSITIVE };
using Comparison_result = Sign;
inline Sign sign_of(int number) { return static_cast<Sign>((number > 0) - (number < 0)); }
inline Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }
inline Sign operator-(Sign a) { return static_cast<Sign>(-static_cast<int>(a)); }

/// An integer times a power of two. Sums, differences and products are exact.
class Mpzf {
 public:
  Mpzf() = default;
  Mpzf(int x) : mantissa_(x) {}
  /// Requires a finite number.
  Mpzf(double x) {
    if (std::bit_cast<std::uint64_t>(x) << 1U == 0) return;
    constexpr int digits = 53;
    const auto integer = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent_), digits));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(integer));
    mantissa_ = integer >> zeros;
    exponent_ += zeros - digits;
  }

  [[nodiscard]] Sign sign() const { return sign_of(mantissa_.sign()); }
  [[nodiscard]] Rational rational() const { return scaled(Rational(mantissa_), exponent_); }

  Mpzf operator-() const { return {-mantissa_, exponent_}; }
  friend Mpzf operator+(const Mpzf& a, const Mpzf& b) {
    if (a.sign() == ZERO) return b;
    if (b.sign() == ZERO) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    return {a.in_units_of(exponent) + b.in_units_of(exponent), exponent};
  }
  friend Mpzf operator-(const Mpzf& a, const Mpzf& b) { return a + -b; }
  friend Mpzf operator*(const Mpzf& a, const Mpzf& b) { return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_}; }
  friend std::strong_ordering operator<=>(const Mpzf& a, const Mpzf& b) {
    if (a.sign() != b.sign()) return a.sign() <=> b.sign();
    return (a - b).sign() <=> ZERO;
  }
  friend bool operator==(const Mpzf& a, const Mpzf& b) { return (a <=> b) == 0; }

 private:
  Mpzf(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}
  [[nodiscard]] Integer in_units_of(int exponent) const { return shifted_up(mantissa_, exponent_ - exponent); }

  Integer mantissa_;
  int exponent_ = 0;
};

inline Sign sign(const Mpzf& x) { return x.sign(); }
inline bool is_zero(const Mpzf& x) { return x.sign() == ZERO; }
inline bool is_positive(const Mpzf& x) { return x.sign() == POSITIVE; }
inline bool is_negative(const Mpzf& x) { return x.sign() == NEGATIVE; }
inline Sign compare(const Mpzf& a, const Mpzf& b) { return a < b ? SMALLER : a == b ? EQUAL : LARGER; }
inline Mpzf abs(const Mpzf& x) { return is_negative(x) ? -x : x; }
inline Mpzf square(const Mpzf& x) { return x * x; }
inline Rational rational(const Mpzf& x) { return x.rational(); }

inline constexpr struct Null_vector {
} NULL_VECTOR;

/// A vector, or the vector from the origin to a point.
class Vector_3 {
 public:
  Vector_3() = default;
  Vector_3(Mpzf x, Mpzf y, Mpzf z) : of_{std::move(x), std::move(y), std::move(z)} {}

  const Mpzf& operator[](int axis) const { return of_[axis]; }
  [[nodiscard]] const Mpzf& x() const { return of_[0]; }
  [[nodiscard]] const Mpzf& y() const { return of_[1]; }
  [[nodiscard]] const Mpzf& z() const { return of_[2]; }
  [[nodiscard]] Mpzf squared_length() const { return *this * *this; }

  Vector_3 operator-() const { return {-x(), -y(), -z()}; }
  friend Vector_3 operator+(const Vector_3& a, const Vector_3& b) {
    return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
  }
  friend Vector_3 operator-(const Vector_3& a, const Vector_3& b) {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }
  friend Vector_3 operator*(const Mpzf& s, const Vector_3& v) { return {s * v.x(), s * v.y(), s * v.z()}; }
  friend Mpzf operator*(const Vector_3& a, const Vector_3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
  friend bool operator==(const Vector_3& v, Null_vector) { return is_zero(v.x()) && is_zero(v.y()) && is_zero(v.z()); }

 private:
  Mpzf of_[3];
};

inline Vector_3 cross_product(const Vector_3& a, const Vector_3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

struct Point_2 {
  Point_2(Mpzf at_x, Mpzf at_y) : x(std::move(at_x)), y(std::move(at_y)) {}

  Mpzf x, y;
};
using Point_3 = Vector_3;

inline Sign orientation(const Point_2& a, const Point_2& b, const Point_2& p) {
  return compare((b.x - a.x) * (p.y - a.y), (b.y - a.y) * (p.x - a.x));
}
inline bool coplanar(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) {
  return is_zero(cross_product(b - a, c - a) * (d - a));
}

template <class Number>
struct Simple_cartesian;
template <>
struct Simple_cartesian<Mpzf> {
  using Point_2 = kernel_of_boost::Point_2;
  using Point_3 = kernel_of_boost::Point_3;
  using Vector_3 = kernel_of_boost::Vector_3;
};

}  // namespace touchstone::kernel_of_boost

namespace touchstone {
namespace kernel = kernel_of_boost;
}
#else
#include <CGAL/Gmpq.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

namespace touchstone {
namespace kernel = CGAL;

/// Returns the same number as a rational number of GMP.
template <class Number>
Rational rational(const Number& number) {
  return Rational(static_cast<CGAL::Gmpq>(number).mpq());
}

}  // namespace touchstone
#endif

namespace touchstone {

/// Returns numerator / denominator, rounded by `round` (nearest_double or nearest_root).
template <class Number, class Round>
double rounded(const Number& numerator, const Number& denominator, Round round) {
  const Rational a = rational(numerator), b = rational(denominator);
  return round(Integer(numerator_of(a) * denominator_of(b)), Integer(numerator_of(b) * denominator_of(a)));
}

namespace exact::detail {

/// The number type of `exact`: integers times powers of two. It has no division, which is not needed here. Rationals
/// and the lazy numbers of EPECK give the same answers, and take several times as long.
using Number = kernel::Mpzf;
/// A vector of exact numbers.
using Vector = kernel::Simple_cartesian<Number>::Vector_3;

/// Returns the same vector in exact numbers.
inline Vector vector(const Eigen::Vector3d& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }

}  // namespace exact::detail

}  // namespace touchstone

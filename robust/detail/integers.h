// SPDX-License-Identifier: Apache-2.0
#pragma once

// Integers and rational numbers of any size: those of GMP, or of Boost.Multiprecision where the library is built with
// TOUCHSTONE_EXACT=OFF, which defines TOUCHSTONE_BOOST_NUMBERS.
#if defined(TOUCHSTONE_BOOST_NUMBERS)
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <gmpxx.h>
#endif

#include <cstdint>

namespace touchstone {

#if defined(TOUCHSTONE_BOOST_NUMBERS)

namespace boost_numbers {
using Backend = boost::multiprecision::cpp_int_backend<512>;  // integers of up to 512 bits are held in place
using RationalBackend = boost::multiprecision::rational_adaptor<Backend>;
}  // namespace boost_numbers
using Integer = boost::multiprecision::number<boost_numbers::Backend, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost_numbers::RationalBackend, boost::multiprecision::et_off>;

inline Integer numerator_of(const Rational& x) { return boost::multiprecision::numerator(x); }
inline Integer denominator_of(const Rational& x) { return boost::multiprecision::denominator(x); }
/// Returns the sign, by the name that GMP has for it.
inline int sgn(const Integer& x) { return x.sign(); }
/// Returns the number of bits of |x|; 1 for 0.
inline long bits(const Integer& x) {
  return x.is_zero() ? 1 : 1 + static_cast<long>(msb(x.sign() < 0 ? Integer(-x) : x));
}

/// @{
/// Returns x 2^shift, and x / 2^shift rounded down. Requires shift >= 0.
inline Integer shifted_up(const Integer& x, long shift) { return x << shift; }
inline Integer shifted_down(const Integer& x, long shift) { return x >> shift; }
inline Integer power_of_two(long exponent) { return Integer(1) << exponent; }
/// @}

/// Returns x 2^exponent, with an exponent of either sign.
inline Rational scaled(const Rational& x, long exponent) {
  return exponent < 0 ? Rational(x / Rational(power_of_two(-exponent)))
                      : Rational(x * Rational(power_of_two(exponent)));
}

/// Divides with a remainder, rounding the quotient towards zero.
inline void divide(const Integer& a, const Integer& b, Integer& quotient, Integer& remainder) {
  divide_qr(a, b, quotient, remainder);
}
/// Returns sqrt(a) to within 1: each step doubles the bits that are known, as in Python's math.isqrt. Boost's own root
/// goes bit by bit. Requires a > 0, and half_bits = (bits(a) - 1) / 2.
inline Integer approximate_root(const Integer& a, long half_bits) {
  if (half_bits == 0) return 1;
  const long shift = (half_bits - 1) / 2;
  const Integer leading = approximate_root(shifted_down(a, 2 * shift + 2), half_bits / 2);
  return shifted_up(leading, shift) + shifted_down(a, shift + 2) / leading;
}

/// Sets root to the integer part of sqrt(a), and remainder to a - root^2. Requires a >= 0.
inline void take_root(const Integer& a, Integer& root, Integer& remainder) {
  root = a.is_zero() ? a : approximate_root(a, (bits(a) - 1) / 2);
  remainder = a - root * root;
  if (remainder.sign() < 0) {
    --root;
    remainder += 2 * root + 1;
  }
}

/// Returns the integer. Requires 0 <= x < 2^64.
inline std::uint64_t word(const Integer& x) { return static_cast<std::uint64_t>(x); }

#else

// What the functions do: see above.

using Integer = mpz_class;
using Rational = mpq_class;

inline const Integer& numerator_of(const Rational& x) { return x.get_num(); }
inline const Integer& denominator_of(const Rational& x) { return x.get_den(); }
inline long bits(const Integer& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

inline Integer shifted_up(const Integer& x, long shift) { return Integer(x << static_cast<mp_bitcnt_t>(shift)); }
inline Integer shifted_down(const Integer& x, long shift) { return Integer(x >> static_cast<mp_bitcnt_t>(shift)); }
inline Integer power_of_two(long exponent) { return shifted_up(Integer(1), exponent); }

inline Rational scaled(Rational x, long exponent) {
  const auto shift = static_cast<mp_bitcnt_t>(exponent < 0 ? -exponent : exponent);
  (exponent < 0 ? mpq_div_2exp : mpq_mul_2exp)(x.get_mpq_t(), x.get_mpq_t(), shift);
  return x;
}

inline void divide(const Integer& a, const Integer& b, Integer& quotient, Integer& remainder) {
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
}
inline void take_root(const Integer& a, Integer& root, Integer& remainder) {
  mpz_sqrtrem(root.get_mpz_t(), remainder.get_mpz_t(), a.get_mpz_t());
}

inline std::uint64_t word(const Integer& x) {
  std::uint64_t result = 0;
  mpz_export(&result, nullptr, -1, sizeof(result), 0, 0, x.get_mpz_t());
  return result;
}

#endif

}  // namespace touchstone

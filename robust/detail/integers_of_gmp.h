// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>

// What the functions do: see integers_of_boost.h.
namespace touchstone {

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

}  // namespace touchstone

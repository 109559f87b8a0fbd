// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/nearest_double.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

namespace touchstone::exact {
namespace {

// The quotient is truncated to an integer of at least this many bits. With one more bit that says whether anything was
// truncated ("sticky"), rounding it to the 53 bits of a double is the same as rounding the exact value.
constexpr long kQuotientBits = 64;

long bits(const mpz_class& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

/// value 2^shift, with shift of either sign.
mpz_class shifted(const mpz_class& value, long shift) {
  return shift >= 0 ? mpz_class(value << static_cast<mp_bitcnt_t>(shift)) : value;
}

/// Frees the memory that MPFR keeps for each thread when the thread ends.
struct ThreadCaches {
  ~ThreadCaches() { mpfr_free_cache(); }
};

/// Rounds (integer + t) 2^exponent, where 0 <= t < 1 and `inexact` says t > 0, to the nearest double.
double rounded(const mpz_class& integer, bool inexact, long exponent) {
  static thread_local const ThreadCaches caches;
  const mpz_class with_sticky = 2 * integer + (inexact ? 1 : 0);
  mpfr_t value;
  mpfr_init2(value, static_cast<mpfr_prec_t>(bits(with_sticky)));
  mpfr_set_z_2exp(value, with_sticky.get_mpz_t(), exponent - 1, MPFR_RNDN);  // exact
  const double result = mpfr_get_d(value, MPFR_RNDN);  // one rounding, possibly to a subnormal number or infinity
  mpfr_clear(value);
  return result;
}

/// Returns the double of opposite sign, except that zero remains +0.
double negated(double value) {
  const bool zero = std::bit_cast<std::uint64_t>(value) == 0;
  return zero ? value : -value;
}

/// An integer part, and whether a positive fraction was truncated.
struct Truncated {
  mpz_class floor;
  bool inexact;
};

/// (term + sign sqrt(radicand)) 2^shift. Requires shift >= 0.
Truncated sum_with_root(const mpz_class& term, int sign, const mpz_class& radicand, long shift) {
  mpz_class root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), shifted(radicand, 2 * shift).get_mpz_t());
  const bool inexact = sign != 0 && rest != 0;
  if (sign < 0 && inexact) ++root;
  return {shifted(term, shift) + sign * root, inexact};
}

}  // namespace

double nearest_double(const mpz_class& numerator, const mpz_class& denominator) {
  assert(denominator > 0);
  if (numerator == 0) return 0;
  const mpz_class magnitude = abs(numerator);
  const long shift = kQuotientBits - (bits(magnitude) - bits(denominator));
  mpz_class quotient, remainder;
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), shifted(magnitude, shift).get_mpz_t(),
              shifted(denominator, -shift).get_mpz_t());
  const double result = rounded(quotient, remainder != 0, -shift);
  return numerator < 0 ? negated(result) : result;
}

double nearest_root(const mpz_class& numerator, const mpz_class& denominator) {
  assert(numerator >= 0 && denominator > 0);
  if (numerator == 0) return 0;
  long shift = 2 * kQuotientBits - (bits(numerator) - bits(denominator));
  if (shift % 2 != 0) ++shift;
  mpz_class quotient, remainder, root, root_remainder;
  mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), shifted(numerator, shift).get_mpz_t(),
              shifted(denominator, -shift).get_mpz_t());
  mpz_sqrtrem(root.get_mpz_t(), root_remainder.get_mpz_t(), quotient.get_mpz_t());
  return rounded(root, remainder != 0 || root_remainder != 0, -shift / 2);
}

double nearest_sum_with_root(const mpz_class& term, int sign, const mpz_class& radicand, const mpz_class& denominator) {
  assert(radicand >= 0 && denominator > 0);
  const int root_sign = radicand == 0 ? 0 : sign;
  const int size = cmp(mpz_class(term * term), mpz_class(root_sign * root_sign * radicand));  // |term| against the root
  const int value_sign = size > 0 ? sgn(term) : size < 0 ? root_sign : root_sign == sgn(term) ? root_sign : 0;
  if (value_sign == 0) return 0;
  if (value_sign < 0) return negated(nearest_sum_with_root(-term, -sign, radicand, denominator));

  // Terms of opposite signs may cancel, so the shift is found by trial.
  long shift = kQuotientBits + bits(denominator) - std::max(bits(term), bits(radicand) / 2);
  for (;; shift += kQuotientBits) {
    const Truncated sum = sum_with_root(term, root_sign, radicand, std::max(shift, 0L));
    mpz_class quotient, remainder;
    mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), sum.floor.get_mpz_t(),
                shifted(denominator, std::max(-shift, 0L)).get_mpz_t());
    if (bits(quotient) >= kQuotientBits && quotient > 0)
      return rounded(quotient, sum.inexact || remainder != 0, -shift);
  }
}

}  // namespace touchstone::exact

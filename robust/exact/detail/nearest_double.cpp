// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/nearest_double.h"

#include <mpfr.h>

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
  const bool zero = std::bit_cast<std::uint64_t>(result) == 0;  // negative values that round to zero become +0, too
  return numerator < 0 && !zero ? -result : result;
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

}  // namespace touchstone::exact

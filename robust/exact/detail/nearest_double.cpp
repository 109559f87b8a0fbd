// SPDX-License-Identifier: Apache-2.0
#include "robust/exact/detail/nearest_double.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::exact::detail {
namespace {

// The quotient is truncated to an integer of at least this many bits. With one more bit that says whether anything was
// truncated ("sticky"), rounding it to the 53 bits of a double is the same as rounding the exact value.
constexpr long kQuotientBits = 64;

/// value 2^shift, or the value itself if shift < 0.
Integer shifted(const Integer& value, long shift) { return shift >= 0 ? shifted_up(value, shift) : value; }

/// Rounds (integer + t) 2^exponent, where 0 <= t < 1 and `inexact` says t > 0, to the nearest double. Requires an
/// integer of at least 64 bits.
double rounded_integer(const Integer& integer, bool inexact, long exponent) {
  constexpr long word_bits = 64, digits = 53, least_exponent = -1074, largest_exponent = 1023 - (digits - 1);
  const long beyond = bits(integer) - word_bits;
  const Integer first_bits = shifted_down(integer, beyond);
  const std::uint64_t leading = word(first_bits);  // its first bit is set
  const bool rest = inexact || shifted_up(first_bits, beyond) != integer;

  // The double is a multiple of 2^unit, one bit more than half of which is the first that it drops.
  const long unit = std::max(exponent + beyond + (word_bits - digits), least_exponent);
  const long dropped = unit - (exponent + beyond);
  if (dropped > word_bits) return 0;
  std::uint64_t kept = dropped == word_bits ? 0 : leading >> dropped;
  const std::uint64_t half = std::uint64_t{1} << (dropped - 1), tail = leading & (half | (half - 1));
  if (tail > half || (tail == half && (rest || kept % 2 != 0))) ++kept;
  if (unit > largest_exponent || (unit == largest_exponent && kept >> digits != 0))
    return std::numeric_limits<double>::infinity();
  return std::ldexp(static_cast<double>(kept), static_cast<int>(unit));  // exact
}

/// Returns the double of opposite sign, except that zero remains +0.
double negated(double value) {
  const bool zero = std::bit_cast<std::uint64_t>(value) == 0;
  return zero ? value : -value;
}

/// An integer part, and whether a positive fraction was truncated.
struct Truncated {
  Integer floor;
  bool inexact;
};

/// (term + sign sqrt(radicand)) 2^shift. Requires shift >= 0.
Truncated sum_with_root(const Integer& term, int sign, const Integer& radicand, long shift) {
  Integer root, rest;
  take_root(shifted(radicand, 2 * shift), root, rest);
  const bool inexact = sign != 0 && rest != 0;
  if (sign < 0 && inexact) ++root;
  return {shifted(term, shift) + sign * root, inexact};
}

}  // namespace

double nearest_double(const Integer& numerator, const Integer& denominator) {
  assert(denominator > 0);
  if (numerator == 0) return 0;
  const Integer magnitude = numerator < 0 ? Integer(-numerator) : numerator;
  const long shift = kQuotientBits - (bits(magnitude) - bits(denominator));
  Integer quotient, remainder;
  divide(shifted(magnitude, shift), shifted(denominator, -shift), quotient, remainder);
  const double result = rounded_integer(quotient, remainder != 0, -shift);
  return numerator < 0 ? negated(result) : result;
}

double nearest_root(const Integer& numerator, const Integer& denominator) {
  assert(numerator >= 0 && denominator > 0);
  if (numerator == 0) return 0;
  long shift = 2 * kQuotientBits - (bits(numerator) - bits(denominator));
  if (shift % 2 != 0) ++shift;
  Integer quotient, remainder, root, root_remainder;
  divide(shifted(numerator, shift), shifted(denominator, -shift), quotient, remainder);
  take_root(quotient, root, root_remainder);
  return rounded_integer(root, remainder != 0 || root_remainder != 0, -shift / 2);
}

double nearest_sum_with_root(const Integer& term, int sign, const Integer& radicand, const Integer& denominator) {
  assert(radicand >= 0 && denominator > 0);
  const int root_sign = radicand == 0 ? 0 : sign;
  const int size = sgn(Integer(term * term - root_sign * root_sign * radicand));  // |term| against the root
  const int value_sign = size > 0 ? sgn(term) : size < 0 ? root_sign : root_sign == sgn(term) ? root_sign : 0;
  if (value_sign == 0) return 0;
  if (value_sign < 0) return negated(nearest_sum_with_root(-term, -sign, radicand, denominator));

  // Terms of opposite signs may cancel, so the shift is found by trial.
  long shift = kQuotientBits + bits(denominator) - std::max(bits(term), bits(radicand) / 2);
  for (;; shift += kQuotientBits) {
    const Truncated sum = sum_with_root(term, root_sign, radicand, std::max(shift, 0L));
    Integer quotient, remainder;
    divide(sum.floor, shifted(denominator, std::max(-shift, 0L)), quotient, remainder);
    if (bits(quotient) >= kQuotientBits && quotient > 0)
      return rounded_integer(quotient, sum.inexact || remainder != 0, -shift);
  }
}

}  // namespace touchstone::exact::detail

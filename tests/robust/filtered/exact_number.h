// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <bit>
#include <cstdint>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/integer.h"

namespace touchstone::filtered_tests {

/// A rational number of GMP that signs.h can be asked with: gmpxx's own operators give expressions, which refer to
/// operands that are gone.
struct Rational {
  mpq_class value;

  friend Rational operator+(const Rational& a, const Rational& b) { return {mpq_class(a.value + b.value)}; }
  friend Rational operator-(const Rational& a, const Rational& b) { return {mpq_class(a.value - b.value)}; }
  friend Rational operator*(const Rational& a, const Rational& b) { return {mpq_class(a.value * b.value)}; }
};

inline mpq_class exactly(double x) { return mpq_class(x); }
inline mpq_class exactly(const filtered::detail::DoubleDouble& x) { return mpq_class(x.high) + mpq_class(x.low); }

/// From its words, two's complement.
template <int Bits>
mpz_class exactly(const filtered::detail::Integer<Bits>& x) {
  constexpr int words = filtered::detail::Integer<Bits>::words + 1;
  const auto text = x.template extended<words>();
  mpz_class value;
  mpz_import(value.get_mpz_t(), text.size(), -1, sizeof(std::uint64_t), 0, 0, text.data());
  if (text.back() >> 63 != 0) value -= mpz_class(1) << (64 * words);
  return value;
}

/// Requires |value| < 2^Bits.
template <int Bits>
filtered::detail::Integer<Bits> integer(const mpz_class& value) {
  using Storage = typename filtered::detail::Integer<Bits>::Storage;
  constexpr std::size_t words = filtered::detail::Integer<Bits>::words;
  std::uint64_t text[words] = {};
  const mpz_class wrapped = value >= 0 ? value : mpz_class(value + (mpz_class(1) << (64 * words)));
  mpz_export(text, nullptr, -1, sizeof(std::uint64_t), 0, 0, wrapped.get_mpz_t());
  if constexpr (Bits < 64)
    return filtered::detail::Integer<Bits>(std::bit_cast<std::int64_t>(text[0]));
  else if constexpr (Bits < 128)
    return filtered::detail::Integer<Bits>(static_cast<Storage>(filtered::detail::Uint128{text[1]} << 64 | text[0]));
  else {
    Storage storage;
    for (std::size_t i = 0; i < words; ++i) storage[i] = text[i];
    return filtered::detail::Integer<Bits>(storage);
  }
}

}  // namespace touchstone::filtered_tests

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstddef>

namespace touchstone::proofs {

inline mpq_class power(const mpq_class& base, std::size_t exponent) {
  mpq_class result = 1;
  for (std::size_t i = 0; i < exponent; ++i) result *= base;
  return result;
}

/// A number above the root, by less than 2^-500 where that is below 2^500.
inline mpq_class root_above(const mpq_class& square) {
  constexpr unsigned kBits = 1100;
  const mpz_class scaled = (square.get_num() << 2 * kBits) / square.get_den() + 1;
  return mpq_class(sqrt(scaled) + 1, mpz_class(1) << kBits);
}

/// A number below the root, by less than 2^-499 where that is below 2^500.
inline mpq_class root_below(const mpq_class& square) { return root_above(square) - mpq_class(1, mpz_class(1) << 500); }

inline const mpq_class kU = 0x1p-53;  ///< the unit of rounding to nearest
inline const mpq_class kSmallestDouble = power(mpq_class(1, 2), 1074);

}  // namespace touchstone::proofs

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

namespace touchstone::exact {

/// The double nearest to numerator / denominator, ties to even; subnormal where it must be, infinite where the value
/// rounds beyond the finite doubles, +0 where it rounds to zero. Requires denominator > 0. Does not depend on the
/// rounding mode.
[[nodiscard]] double nearest_double(const mpz_class& numerator, const mpz_class& denominator);

/// The double nearest to sqrt(numerator / denominator), in the same sense. Requires numerator >= 0, denominator > 0.
[[nodiscard]] double nearest_root(const mpz_class& numerator, const mpz_class& denominator);

}  // namespace touchstone::exact

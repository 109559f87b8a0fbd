// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/detail/integers.h"

namespace touchstone::exact::detail {

/// Returns the double nearest to numerator / denominator, ties to even. The result may be subnormal, is infinite if the
/// value rounds beyond the finite doubles, and +0 if it rounds to zero. Requires denominator > 0. Does not depend on
/// the rounding mode.
[[nodiscard]] double nearest_double(const Integer& numerator, const Integer& denominator);

/// Returns the double nearest to sqrt(numerator / denominator), in the same sense. Requires numerator >= 0, denominator
/// > 0.
[[nodiscard]] double nearest_root(const Integer& numerator, const Integer& denominator);

/// Returns the double nearest to (term + sign sqrt(radicand)) / denominator, in the same sense. Requires a sign of -1,
/// 0 or +1, radicand >= 0, and denominator > 0.
[[nodiscard]] double nearest_sum_with_root(const Integer& term, int sign, const Integer& radicand,
                                           const Integer& denominator);

}  // namespace touchstone::exact::detail

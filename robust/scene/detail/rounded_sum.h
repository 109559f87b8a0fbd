// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/permanent.h"

/// Correctly rounded sums of three products and a double, as poses need them.
namespace touchstone::scene {

/// The sum of numbers, added up one after the other.
template <class... Numbers>
constexpr auto added_up(const Numbers&... numbers) {
  return (... + numbers);
}

/// What `added_up` says of six doubles may be off, and what its sum with this error is off once more: so many times the
/// magnitudes that it adds up. Proved in tests/proofs/rounded_sum_test.cpp.
inline constexpr double kSumError = 0x1p-50;

/// The double nearest to x + y + z + t, if error-free transformations can tell. Requires round to nearest, without
/// flush-to-zero, and that nothing overflows.
///
/// The sum is that of a double, `sum`, and of six small ones, without any error. Additions lose nothing to underflow;
/// where the product that is the error does, by 2^-1075, the magnitudes are above 2^-1021 and that is a sixteenth of
/// it, or they are not, and small ones of that size were added without error. Rounding is monotone: where both ends
/// round to one double, so does the exact sum.
inline std::optional<double> rounded_sum(const filtered::DoubleDouble& x, const filtered::DoubleDouble& y,
                                         const filtered::DoubleDouble& z, double t) {
  using filtered::DoubleDouble, filtered::two_sum, filtered::exact_double;
  const DoubleDouble first = two_sum(x.high, y.high), second = two_sum(first.high, z.high);
  const DoubleDouble third = two_sum(second.high, t);
  const double sum = third.high;
  const auto rest = added_up(exact_double(x.low), exact_double(y.low), exact_double(z.low), exact_double(first.low),
                             exact_double(second.low), exact_double(third.low));
  const double error = kSumError * rest.permanent;
  const double result = sum + (rest.value + error);
  if (result == sum + (rest.value - error)) return result;  // compared as rounded
  // On a tie, which translations by round numbers give every second time: the small ones are often one double.
  DoubleDouble all(0.0);
  for (const double s : std::array{x.low, y.low, z.low, first.low, second.low, third.low}) {
    const DoubleDouble next = two_sum(all.high, s);
    if (next.low != 0) return std::nullopt;  // exact
    all = next;
  }
  return sum + all.high;
}

}  // namespace touchstone::scene

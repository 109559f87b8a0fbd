// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "robust/filtered/detail/numbers/double_double.h"
#include "robust/filtered/detail/numbers/permanent.h"

/// Correctly rounded sums of three products and a double, for poses.
namespace touchstone::scene::detail {

/// Returns the sum of the numbers, added from left to right.
template <class... Numbers>
constexpr auto added_up(const Numbers&... numbers) {
  return (... + numbers);
}

/// Bounds the error of `added_up` for six doubles, and of adding this error to its result, relative to the sum of the
/// magnitudes. Proved in tests/robust/proofs/rounded_sum_test.cpp.
inline constexpr double kSumError = 0x1p-50;

/// Returns the double nearest to x + y + z + t, if error-free transformations can decide it. Requires round to nearest,
/// without flush-to-zero, and no overflow.
///
/// The exact sum equals a double, `sum`, plus six small doubles. Additions lose nothing to underflow. The product that
/// yields the error may lose 2^-1075: if the magnitudes are above 2^-1021, that is a sixteenth of it; if they are not,
/// small doubles of that size were added without error. Rounding is monotone: if both ends of the interval round to the
/// same double, so does the exact sum.
inline std::optional<double> rounded_sum(const filtered::detail::DoubleDouble& x,
                                         const filtered::detail::DoubleDouble& y,
                                         const filtered::detail::DoubleDouble& z, double t) {
  using filtered::detail::DoubleDouble, filtered::detail::two_sum, filtered::detail::exact_double;
  const DoubleDouble first = two_sum(x.high, y.high), second = two_sum(first.high, z.high);
  const DoubleDouble third = two_sum(second.high, t);
  const double sum = third.high;
  const auto rest = added_up(exact_double(x.low), exact_double(y.low), exact_double(z.low), exact_double(first.low),
                             exact_double(second.low), exact_double(third.low));
  const double error = kSumError * rest.permanent;
  const double result = sum + (rest.value + error);
  if (result == sum + (rest.value - error)) return result;  // compared as rounded
  // On a tie, which is frequent for translations by round numbers: the sum of the small doubles is often one double.
  DoubleDouble all(0.0);
  for (const double s : std::array{x.low, y.low, z.low, first.low, second.low, third.low}) {
    const DoubleDouble next = two_sum(all.high, s);
    if (next.low != 0) return std::nullopt;  // exact
    all = next;
  }
  return sum + all.high;
}

}  // namespace touchstone::scene::detail

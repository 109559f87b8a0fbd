// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "robust/detail/exact_kernel.h"

namespace touchstone::exact::detail {

/// The quadratic a t^2 + 2 b t + c.
struct Quadratic {
  Number a, b, c;
};

/// A linear function p + q t.
struct Linear {
  Number p, q;
};

/// The smaller root of a quadratic with a > 0, b < 0 and c > 0. Only signs of polynomials of a, b and c compare it with
/// other numbers. Source: [karavelas2003].
class SmallerRoot {
 public:
  /// Returns the root if it is in (0, 1]. A quadratic with a = 0 has none, nor has one with c <= 0: it describes an
  /// obstacle that is reached at t = 0 or before. Requires a >= 0.
  [[nodiscard]] static std::optional<SmallerRoot> within_unit_interval(const Quadratic& quadratic);

  /// Returns whether it is a double root.
  [[nodiscard]] bool is_double() const { return kernel::is_zero(discriminant_); }
  /// Returns the sign of the function at the root.
  [[nodiscard]] kernel::Sign sign_of(const Linear& function) const;
  /// Returns the double nearest to the function's value at the root, divided by the divisor. Requires divisor > 0.
  [[nodiscard]] double rounded(const Linear& function, const Number& divisor) const;

  /// Returns SMALLER, EQUAL or LARGER.
  friend kernel::Comparison_result compare(const SmallerRoot& first, const SmallerRoot& second);

 private:
  SmallerRoot(const Quadratic& quadratic, Number discriminant);

  // The root is (-b - sqrt(discriminant)) / a.
  Number a_, b_, discriminant_;
};

}  // namespace touchstone::exact::detail

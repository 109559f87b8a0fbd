// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace touchstone::stability {

/// A rounding direction, and whether subnormal results (FTZ) and operands (DAZ) are replaced by zero: bits of the
/// MXCSR. Without SSE2 nothing is flushed.
struct FloatingPointMode {
  static constexpr unsigned kGivenAsZero = 0x8000, kTakenAsZero = 0x0040;

  int rounding = FE_TONEAREST;
  unsigned flush = 0;

  [[nodiscard]] bool usual() const { return rounding == FE_TONEAREST && flush == 0; }
};

/// Sets the mode during its lifetime, then restores the previous one.
class Environment {
 public:
  explicit Environment(const FloatingPointMode& mode) {
    std::fegetenv(&found_);
    std::fesetround(mode.rounding);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | mode.flush);
#endif
  }
  ~Environment() { std::fesetenv(&found_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::fenv_t found_;
};

}  // namespace touchstone::stability

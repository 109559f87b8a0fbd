// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace touchstone::contact_tests {

inline constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
inline constexpr int kFlags = FE_INVALID | FE_OVERFLOW | FE_DIVBYZERO;

/// A rounding mode, and subnormals taken (DAZ) and given (FTZ) as 0, while it lives.
class Environment {
 public:
  enum Flush : unsigned { kKeep = 0, kGivenAsZero = 0x8000, kTakenAsZero = 0x0040, kBoth = 0x8040 };

  Environment(int mode, unsigned flush) {
    std::fegetenv(&found_);
    std::fesetround(mode);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | flush);
#else
    (void)flush;
#endif
  }
  ~Environment() { std::fesetenv(&found_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  /// The rounding mode, flush bits and masks that hold now.
  static unsigned modes() {
    auto now = static_cast<unsigned>(std::fegetround());
#if defined(__SSE2__)
    now |= (_mm_getcsr() & ~0x3fU) << 12;
#endif
    return now;
  }

 private:
  std::fenv_t found_;
};

inline constexpr unsigned kFlushes[] = {Environment::kKeep, Environment::kGivenAsZero, Environment::kTakenAsZero,
                                        Environment::kBoth};

}  // namespace touchstone::contact_tests

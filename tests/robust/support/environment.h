// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cfenv>
#include <ostream>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace touchstone::contact_tests {

inline constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
inline constexpr int kFlags = FE_INVALID | FE_OVERFLOW | FE_DIVBYZERO;

/// A rounding mode, and what is done with subnormals.
struct State {
  int mode;
  unsigned flush;
};

/// A rounding mode, and subnormals taken (DAZ) and given (FTZ) as 0, while it lives. At first no exception flag is set.
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
    std::feclearexcept(FE_ALL_EXCEPT);
    modes_ = modes();
  }
  explicit Environment(const State& state) : Environment(state.mode, state.flush) {}
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

  /// Are these as they were at first, and of kFlags only `flags` set?
  [[nodiscard]] bool left_as_found(int flags = 0) const {
    return modes() == modes_ && std::fetestexcept(kFlags) == flags;
  }

 private:
  std::fenv_t found_;
  unsigned modes_;
};

inline constexpr unsigned kFlushes[] = {Environment::kKeep, Environment::kGivenAsZero, Environment::kTakenAsZero,
                                        Environment::kBoth};

inline constexpr auto kStates = [] {
  std::array<State, std::size(kModes) * std::size(kFlushes)> states{};
  std::size_t i = 0;
  for (const int mode : kModes)
    for (const unsigned flush : kFlushes) states[i++] = {mode, flush};
  return states;
}();

inline std::ostream& operator<<(std::ostream& out, const State& state) {
  return out << "rounding mode " << state.mode << ", flush bits " << state.flush;
}

}  // namespace touchstone::contact_tests

// SPDX-License-Identifier: GPL-3.0-or-later
// For test_every_state.py, by ctypes: Python has no way to the state of the floating-point unit.
#include <cfenv>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

extern "C" {

/// Rounding mode 0 to 3: to nearest, up, down, towards zero; flush 0 to 3: neither, subnormals given as zero, taken as
/// zero, both. Returns nothing; (0, 0) is the default state.
void set_state(int rounding, int flush) {
  constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
  std::fesetround(kModes[rounding]);
#if defined(__SSE2__)
  constexpr unsigned kGivenAsZero = 0x8000, kTakenAsZero = 0x0040;
  const unsigned kept = _mm_getcsr() & ~(kGivenAsZero | kTakenAsZero);
  _mm_setcsr(kept | ((flush & 1) != 0 ? kGivenAsZero : 0) | ((flush & 2) != 0 ? kTakenAsZero : 0));
#else
  (void)flush;
#endif
}

/// The mode and the flush bits that hold now, as one number.
unsigned state() {
  auto now = static_cast<unsigned>(std::fegetround());
#if defined(__SSE2__)
  now |= (_mm_getcsr() & 0xffc0U) << 12;
#endif
  return now;
}

}  // extern "C"

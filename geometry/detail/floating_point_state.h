// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cfenv>
#include <type_traits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace touchstone {

/// Returns the value, opaque to the compiler: it is computed before this call, and everything computed from the result
/// comes after it. Cost: none for doubles, integers and enumerations; a move for other types.
template <class T>
[[nodiscard]] __attribute__((always_inline)) inline T pinned(T value) {
  if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) __asm__ volatile("" : "+r"(value) : : "memory");
#if defined(__SSE2__)
  else if constexpr (std::is_same_v<T, double>)
    __asm__ volatile("" : "+x"(value) : : "memory");
#endif
  else
    __asm__ volatile("" : : "r"(&value) : "memory");
  return value;
}

/// Sets round to nearest with subnormal numbers for its lifetime, and then restores the caller's rounding mode,
/// flush-to-zero setting, traps and exception flags. No exception traps during its lifetime. Cost: a few ns with SSE2,
/// about 10 if something has to be set.
///
/// Compilers do not know about rounding modes: -frounding-math does not keep g++ from moving arithmetic past a change
/// of mode, and clang++ does not have that flag. Reads and writes of memory stay on their side of the change;
/// arithmetic in registers need not. Therefore this must be the first statement of a function. Numbers must be read
/// through references or pass through `pinned`, and so must a result whose last step is arithmetic in doubles or a
/// comparison of them:
///
///     double growth(const Boxes& boxes, double factor) {
///       const FloatingPointState nearest;
///       return pinned(factor_of(boxes) * pinned(factor));
///     }
///
/// tests/system/build/state_holds_arithmetic.py searches the compiled library for arithmetic on the wrong side.
class FloatingPointState {
 public:
#if defined(__SSE2__)
  __attribute__((always_inline)) FloatingPointState() : found_(_mm_getcsr()) {
    if ((found_ & ~kFlags) != kDefault) _mm_setcsr(kDefault);
    order_memory();
  }
  __attribute__((always_inline)) ~FloatingPointState() {
    order_memory();
    if (_mm_getcsr() != found_) _mm_setcsr(found_);
  }
#else
  FloatingPointState() {
    std::fegetenv(&found_);
    std::fesetenv(FE_DFL_ENV);
    order_memory();
  }
  ~FloatingPointState() {
    order_memory();
    std::fesetenv(&found_);
  }
#endif
  /// Returns whether the state is found to be as the constructor would set it. False if that cannot be read fast.
  [[nodiscard]] __attribute__((always_inline)) static bool is_found() {
#if defined(__SSE2__)
    return (_mm_getcsr() & ~kFlags) == kDefault;
#else
    return false;
#endif
  }
  FloatingPointState(const FloatingPointState&) = delete;
  FloatingPointState& operator=(const FloatingPointState&) = delete;

 private:
  /// Makes the compiler read memory again after this point, and complete all writes before it.
  __attribute__((always_inline)) static void order_memory() { __asm__ volatile("" : : : "memory"); }

#if defined(__SSE2__)
  static constexpr unsigned kFlags = 0x3f;      // exceptions that have been raised
  static constexpr unsigned kDefault = 0x1f80;  // all exceptions masked, nearest, neither flush- nor denormals-to-zero
  unsigned found_;
#else
  std::fenv_t found_;
#endif
};

}  // namespace touchstone

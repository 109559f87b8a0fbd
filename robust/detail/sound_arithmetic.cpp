// SPDX-License-Identifier: Apache-2.0
// Does not include geometry/floating_point.h: this file tests what the compiler does, not which macros it defines.
#include "robust/detail/sound_arithmetic.h"

#include <bit>
#include <cfenv>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace touchstone {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::logic_error("Touchstone was compiled with flags that break its arithmetic: " + what +
                         ". Compile it without -ffast-math and the flags that are part of it.");
}

}  // namespace

void expect_sound_arithmetic() {
  // Volatile, so that the compiler knows the operations but not the operands.
  volatile double one = 1, small = 0x1p-60, negative_zero = -0.0, five = 5;

  const double a = one, b = small, sum = a + b, b_in_sum = sum - a;
  const double error = (a - (sum - b_in_sum)) + (b - b_in_sum);
  if (std::bit_cast<std::uint64_t>(error) != std::bit_cast<std::uint64_t>(b))
    refuse("sums are reordered (-fassociative-math, -funsafe-math-optimizations)");

  const double zero = negative_zero + 0.0;
  if (std::bit_cast<std::uint64_t>(zero) != 0) refuse("the sign of a zero is lost (-fno-signed-zeros)");

  // The double nearest to 5 / 3; five times the double nearest to 1 / 3 is the one below.
  const double third = five / 3.0;
  if (std::bit_cast<std::uint64_t>(third) != 0x3ffaaaaaaaaaaaab)
    refuse("quotients become products with reciprocals (-freciprocal-math)");
}

bool has_directed_rounding() noexcept {
#if defined(FE_UPWARD)
  volatile double one = 1, small = 0x1p-60;  // as above; and accesses stay between the calls
  const int mode = std::fegetround();
  std::fesetround(FE_UPWARD);
  volatile double above = one + small;
  std::fesetround(mode);
  return above > 1;
#else
  return false;
#endif
}

}  // namespace touchstone

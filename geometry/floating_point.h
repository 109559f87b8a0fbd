// SPDX-License-Identifier: Apache-2.0
#pragma once

// Refuses to compile unless doubles are IEEE-754 doubles, evaluated as doubles, by a compiler that leaves expressions
// as written. Every answer depends on that. Contraction to fused multiply-add cannot be detected here; the build sets
// -ffp-contract=off. Flags for which a compiler defines no macro are detected when the library is first used.

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__)
#error "Touchstone refuses -ffast-math: it lets the compiler reorder sums, so no error bound and no sign holds."
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "Touchstone refuses -ffinite-math-only: its guards compare with infinities and NaNs, which that flag removes."
#endif
#if defined(__ASSOCIATIVE_MATH__)
#error "Touchstone refuses -fassociative-math: error-free transformations vanish when sums are reordered."
#endif
#if defined(__RECIPROCAL_MATH__)
#error "Touchstone refuses -freciprocal-math: x / y would be rounded twice."
#endif
#if defined(__NO_SIGNED_ZEROS__)
#error "Touchstone refuses -fno-signed-zeros: it changes what x + 0 may be rewritten to."
#endif
#if defined(__NO_TRAPPING_MATH__)
#error "Touchstone refuses -fno-trapping-math: floating-point flags and guards would be moved across each other."
#endif
#if FLT_EVAL_METHOD != 0
#error "Touchstone needs FLT_EVAL_METHOD == 0: intermediate results in a wider format are rounded twice."
#endif

static_assert(0x1p-600 > 0 && 1 + 0x1p-48 > 1,
              "Touchstone refuses -fsingle-precision-constant: its error bounds need double precision.");
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "Touchstone needs IEEE-754 binary64 doubles.");

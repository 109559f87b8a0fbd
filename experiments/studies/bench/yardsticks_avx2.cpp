// SPDX-License-Identifier: GPL-3.0-or-later
// For x86-64 with AVX2 and FMA; CMakeLists.txt sets the flags.
#if defined(__AVX2__) && defined(__FMA__)
#define TOUCHSTONE_TARGET avx2
#include "experiments/studies/bench/yardsticks_definition.h"

namespace touchstone::bench {

detail::Yardsticks detail::avx2_yardsticks() { return {without_floats, tree_contact}; }

}  // namespace touchstone::bench
#endif

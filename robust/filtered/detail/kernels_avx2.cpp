// SPDX-License-Identifier: Apache-2.0
// The kernels for x86-64 with AVX2 and FMA; robust/CMakeLists.txt sets the flags.
#if defined(__AVX2__) && defined(__FMA__)
#define TOUCHSTONE_TARGET avx2
#include "robust/filtered/detail/kernels_definition.h"

namespace touchstone::filtered::detail {

const Kernels& avx2_kernels() { return kKernels; }

}  // namespace touchstone::filtered::detail
#endif

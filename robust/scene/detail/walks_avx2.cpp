// SPDX-License-Identifier: Apache-2.0
// The walks for x86-64 with AVX2 and FMA; robust/CMakeLists.txt sets the flags.
#if defined(__AVX2__) && defined(__FMA__)
#define TOUCHSTONE_TARGET avx2
#include "robust/scene/detail/walks_definition.h"

namespace touchstone::scene::detail {

const Walks& avx2_walks() { return kWalks; }

}  // namespace touchstone::scene::detail
#endif

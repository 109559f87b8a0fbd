// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/walks.h"

#include "robust/detail/sound_arithmetic.h"
#include "robust/scene/detail/walks_definition.h"

namespace touchstone::scene::detail {

namespace {

bool has_avx2() {
  static const bool has = [] {
    expect_sound_arithmetic();
#if defined(TOUCHSTONE_HAS_AVX2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
    return false;
#endif
  }();
  return has;
}

}  // namespace

#if !defined(TOUCHSTONE_HAS_AVX2)
const Walks& avx2_walks() { return baseline_walks(); }
#endif

const Walks& fastest_walks() { return has_avx2() ? avx2_walks() : baseline_walks(); }

const Walks& baseline_walks() { return kWalks; }

}  // namespace touchstone::scene::detail

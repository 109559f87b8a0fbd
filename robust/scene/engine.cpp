// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/engine.h"

namespace touchstone::scene {

const Engine& engine() {
#if defined(TOUCHSTONE_HAS_AVX2)
  static const Engine& fastest =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? avx2_engine() : baseline_engine();
  return fastest;
#else
  return baseline_engine();
#endif
}

}  // namespace touchstone::scene

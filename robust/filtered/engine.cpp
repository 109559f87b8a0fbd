// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/engine.h"

namespace touchstone::filtered {

const Engine& fastest_engine() {
#if defined(TOUCHSTONE_HAS_AVX2)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_engine();
#endif
  return baseline_engine();
}

}  // namespace touchstone::filtered

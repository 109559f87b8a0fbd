// SPDX-License-Identifier: Apache-2.0
#include "robust/filtered/detail/kernels.h"

#include "geometry/detail/floating_point_state.h"
#include "robust/detail/sound_arithmetic.h"
#include "robust/filtered/detail/kernels_definition.h"

namespace touchstone::filtered::detail {

constinit std::atomic<const Kernels*> found_kernels = nullptr;

const Kernels& find_fastest_kernels() {
  const FloatingPointState nearest;
  expect_sound_arithmetic();
  const Kernels* fastest = &baseline_kernels();
#if defined(TOUCHSTONE_HAS_AVX2)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) fastest = &avx2_kernels();
#endif
  found_kernels.store(fastest, std::memory_order_relaxed);
  return *fastest;
}

const Kernels& baseline_kernels() { return kKernels; }

}  // namespace touchstone::filtered::detail

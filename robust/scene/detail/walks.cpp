// SPDX-License-Identifier: Apache-2.0
#include "robust/scene/detail/walks.h"

#include "robust/filtered/detail/kernels.h"
#include "robust/scene/detail/walks_definition.h"

namespace touchstone::scene::detail {

const Walks& fastest_walks() {
  [[maybe_unused]] const filtered::detail::Kernels& fastest = filtered::detail::kernels();
#if defined(TOUCHSTONE_HAS_AVX2)
  if (&fastest == &filtered::detail::avx2_kernels()) return avx2_walks();
#endif
  return baseline_walks();
}

const Walks& baseline_walks() { return kWalks; }

}  // namespace touchstone::scene::detail

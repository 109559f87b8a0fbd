// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/variants.h"

#include "experiments/studies/bench/variants_definition.h"

namespace touchstone::bench {

const std::vector<Variant>& detail::baseline_variants() { return all_variants(); }

const std::vector<Variant>& variants() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return detail::avx2_variants();
#endif
  return detail::baseline_variants();
}

}  // namespace touchstone::bench

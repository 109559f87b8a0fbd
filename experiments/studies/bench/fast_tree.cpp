// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/fast_tree.h"

#include "experiments/studies/bench/fast_tree_definition.h"

namespace touchstone::bench {

bool detail::baseline_tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon) {
  return tree_contact(ball, polygon);
}

bool contact(const Ball& ball, const FastTree& polygon) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (has_avx2) return detail::avx2_tree_contact(ball, polygon.prepared_);
#endif
  return detail::baseline_tree_contact(ball, polygon.prepared_);
}

}  // namespace touchstone::bench

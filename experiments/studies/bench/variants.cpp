// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/studies/bench/variants.h"

#include "experiments/studies/bench/variants_definition.h"

namespace touchstone::bench {

const std::vector<Variant>& detail::baseline_variants() { return all_variants(); }

detail::SetContact detail::baseline_set_contact() { return without_floats; }

#if defined(__x86_64__)
namespace {

bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

}  // namespace
#endif

const std::vector<Variant>& variants() {
#if defined(__x86_64__)
  if (has_avx2()) return detail::avx2_variants();
#endif
  return detail::baseline_variants();
}

void set_contact_without_floats(const Ball& ball, const filtered::TriangleSet& set, std::span<bool> touches) {
#if defined(__x86_64__)
  static const detail::SetContact contact = has_avx2() ? detail::avx2_set_contact() : detail::baseline_set_contact();
#else
  static const detail::SetContact contact = detail::baseline_set_contact();
#endif
  contact(ball, set, touches);
}

bool detail::baseline_tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon) {
  return tree_contact(ball, polygon);
}

bool contact(const Ball& ball, const FastTree& polygon) {
#if defined(__x86_64__)
  static const bool uses_avx2 = has_avx2();
  if (uses_avx2) return detail::avx2_tree_contact(ball, polygon.prepared_);
#endif
  return detail::baseline_tree_contact(ball, polygon.prepared_);
}

}  // namespace touchstone::bench

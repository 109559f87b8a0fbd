// SPDX-License-Identifier: GPL-3.0-or-later
// For x86-64 with AVX2 and FMA; CMakeLists.txt sets the flags.
#if defined(__AVX2__) && defined(__FMA__)
#define TOUCHSTONE_TARGET avx2
#include "experiments/studies/bench/variants_definition.h"

namespace touchstone::bench {

const std::vector<Variant>& detail::avx2_variants() { return all_variants(); }
detail::SetContact detail::avx2_set_contact() { return without_floats; }

bool detail::avx2_tree_contact(const Ball& ball, const filtered::PreparedPolygon& polygon) {
  return tree_contact(ball, polygon);
}

}  // namespace touchstone::bench
#endif

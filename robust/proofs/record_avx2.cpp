// SPDX-License-Identifier: Apache-2.0
// What record.cpp records of lanes, for AVX2 and FMA; CMakeLists.txt sets the flags.
#define TOUCHSTONE_TARGET avx2
#include "robust/proofs/lane_functions.h"

namespace touchstone::proofs {

void print_avx2() {
  print_claims_of_lanes();
  print_functions_in_lanes("AVX2");
  print_transformations("AVX2");
}

}  // namespace touchstone::proofs

// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "geometry/floating_point.h"
#include "robust/filtered/target.h"

/// Four doubles that are worked on at once, in whatever vector registers the target has.
///
/// Arithmetic is that of each lane alone: no lane's result depends on the instruction set. Masks are 64 bits wide a
/// lane, as comparisons give them.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"  // these types are never passed across translation units

using Pack = double __attribute__((vector_size(32)));
using Mask = long long __attribute__((vector_size(32)));
inline constexpr int kLanes = 4;

#define TOUCHSTONE_INLINE inline __attribute__((always_inline))

TOUCHSTONE_INLINE Pack all_lanes(double value) { return Pack{value, value, value, value}; }
TOUCHSTONE_INLINE Pack select(const Mask& mask, const Pack& a, const Pack& b) {
  return (Pack)((mask & (Mask)a) | (~mask & (Mask)b));
}
TOUCHSTONE_INLINE Pack magnitude(const Pack& a) {
  constexpr long long bits = 0x7fffffffffffffff;
  return (Pack)((Mask)a & Mask{bits, bits, bits, bits});
}
/// The larger of each pair of lanes; neither may be NaN.
TOUCHSTONE_INLINE Pack maximum(const Pack& a, const Pack& b) {
#if defined(__AVX__)
  return _mm256_max_pd(a, b);
#else
  return a > b ? a : b;
#endif
}

/// One bit a lane: is the mask set there?
TOUCHSTONE_INLINE unsigned lanes(const Mask& mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask));
#elif defined(__SSE2__)
  using Half = long long __attribute__((vector_size(16)));
  const Half low = {mask[0], mask[1]}, high = {mask[2], mask[3]};
  return static_cast<unsigned>(_mm_movemask_pd((__m128d)low)) | static_cast<unsigned>(_mm_movemask_pd((__m128d)high)) << 2;
#else
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= (mask[i] != 0 ? 1U : 0U) << i;
  return bits;
#endif
}

#pragma GCC diagnostic pop

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

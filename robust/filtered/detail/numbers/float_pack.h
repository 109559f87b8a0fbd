// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "robust/filtered/detail/numbers/pack.h"

namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

inline constexpr int kFloatLanes = 8;

/// Eight floats that are processed together, in the vector registers of the target: one of AVX, two of SSE2, or plain
/// floats. Operations, truth values of lanes and fused products are like those of Pack; minimum(a, b) and maximum(a, b)
/// are b where a is not a number. Integers are loaded from addresses that are multiples of 16.
#if defined(__AVX2__)

struct FloatPack {
  __m256 lanes;
};
TOUCHSTONE_INLINE FloatPack all_float_lanes(float value) { return {_mm256_set1_ps(value)}; }
TOUCHSTONE_INLINE void store(float* eight, const FloatPack& a) { _mm256_storeu_ps(eight, a.lanes); }
TOUCHSTONE_INLINE FloatPack load_eight(const float* eight) { return {_mm256_loadu_ps(eight)}; }
TOUCHSTONE_INLINE FloatPack load(const std::int16_t* eight) {
  return {_mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(eight))))};
}
TOUCHSTONE_INLINE FloatPack load(const std::uint16_t* eight) {
  return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(eight))))};
}
TOUCHSTONE_INLINE FloatPack operator+(const FloatPack& a, const FloatPack& b) {
  return {_mm256_add_ps(a.lanes, b.lanes)};
}
TOUCHSTONE_INLINE FloatPack operator-(const FloatPack& a, const FloatPack& b) {
  return {_mm256_sub_ps(a.lanes, b.lanes)};
}
TOUCHSTONE_INLINE FloatPack operator*(const FloatPack& a, const FloatPack& b) {
  return {_mm256_mul_ps(a.lanes, b.lanes)};
}
TOUCHSTONE_INLINE FloatPack operator/(const FloatPack& a, const FloatPack& b) {
  return {_mm256_div_ps(a.lanes, b.lanes)};
}
TOUCHSTONE_INLINE FloatPack square_root(const FloatPack& a) { return {_mm256_sqrt_ps(a.lanes)}; }
TOUCHSTONE_INLINE FloatPack minimum(const FloatPack& a, const FloatPack& b) {
  return {_mm256_min_ps(a.lanes, b.lanes)};
}
TOUCHSTONE_INLINE FloatPack maximum(const FloatPack& a, const FloatPack& b) {
  return {_mm256_max_ps(a.lanes, b.lanes)};
}
/// Returns a where `condition` is true, and b elsewhere.
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  return {_mm256_blendv_ps(b.lanes, a.lanes, condition.lanes)};
}
TOUCHSTONE_INLINE unsigned negative_lanes(const FloatPack& a) {
  return static_cast<unsigned>(_mm256_movemask_ps(a.lanes));
}
/// Returns the least number of the first `count` lanes, which is from 1 to 8. Requires numbers.
TOUCHSTONE_INLINE float least_of_first(const FloatPack& a, unsigned count) {
  const __m256i lane = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
  // Lane 0 in place of the lanes that do not count.
  const __m256i in = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(count)), lane);
  const __m256 all = _mm256_permutevar8x32_ps(a.lanes, _mm256_and_si256(in, lane));
  const __m128 four = _mm_min_ps(_mm256_castps256_ps128(all), _mm256_extractf128_ps(all, 1));
  const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
}
#if defined(__FMA__)
TOUCHSTONE_INLINE FloatPack multiply_add(const FloatPack& a, const FloatPack& b, const FloatPack& c) {
  return {_mm256_fmadd_ps(a.lanes, b.lanes, c.lanes)};
}
TOUCHSTONE_INLINE FloatPack multiply_subtract(const FloatPack& a, const FloatPack& b, const FloatPack& c) {
  return {_mm256_fmsub_ps(a.lanes, b.lanes, c.lanes)};
}
#endif

#elif defined(__SSE2__)

struct FloatPack {
  __m128 low, high;
};
TOUCHSTONE_INLINE FloatPack all_float_lanes(float value) { return {_mm_set1_ps(value), _mm_set1_ps(value)}; }
TOUCHSTONE_INLINE void store(float* eight, const FloatPack& a) {
  _mm_storeu_ps(eight, a.low);
  _mm_storeu_ps(eight + 4, a.high);
}
TOUCHSTONE_INLINE FloatPack load_eight(const float* eight) { return {_mm_loadu_ps(eight), _mm_loadu_ps(eight + 4)}; }
TOUCHSTONE_INLINE FloatPack load(const std::int16_t* eight) {
  const __m128i integers = _mm_load_si128(reinterpret_cast<const __m128i*>(eight));
  // Each integer in the upper half of 32 bits, then shifted down with its sign.
  const __m128i low = _mm_srai_epi32(_mm_unpacklo_epi16(integers, integers), 16);
  const __m128i high = _mm_srai_epi32(_mm_unpackhi_epi16(integers, integers), 16);
  return {_mm_cvtepi32_ps(low), _mm_cvtepi32_ps(high)};
}
TOUCHSTONE_INLINE FloatPack load(const std::uint16_t* eight) {
  const __m128i integers = _mm_load_si128(reinterpret_cast<const __m128i*>(eight)), zero = _mm_setzero_si128();
  return {_mm_cvtepi32_ps(_mm_unpacklo_epi16(integers, zero)), _mm_cvtepi32_ps(_mm_unpackhi_epi16(integers, zero))};
}
TOUCHSTONE_INLINE FloatPack operator+(const FloatPack& a, const FloatPack& b) {
  return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack operator-(const FloatPack& a, const FloatPack& b) {
  return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack operator*(const FloatPack& a, const FloatPack& b) {
  return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack operator/(const FloatPack& a, const FloatPack& b) {
  return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack square_root(const FloatPack& a) { return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)}; }
TOUCHSTONE_INLINE FloatPack minimum(const FloatPack& a, const FloatPack& b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack maximum(const FloatPack& a, const FloatPack& b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  const auto half = [](const __m128& c, const __m128& x, const __m128& y) {
    const __m128 chosen = _mm_castsi128_ps(_mm_srai_epi32(_mm_castps_si128(c), 31));
    return _mm_or_ps(_mm_and_ps(chosen, x), _mm_andnot_ps(chosen, y));
  };
  return {half(condition.low, a.low, b.low), half(condition.high, a.high, b.high)};
}
TOUCHSTONE_INLINE unsigned negative_lanes(const FloatPack& a) {
  return static_cast<unsigned>(_mm_movemask_ps(a.low) | _mm_movemask_ps(a.high) << 4);
}

#else

struct FloatPack {
  float lanes[kFloatLanes];
};
template <class F>
TOUCHSTONE_INLINE FloatPack each_float_lane(F f) {
  return {{f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)}};
}
TOUCHSTONE_INLINE FloatPack all_float_lanes(float value) {
  return each_float_lane([&](int) { return value; });
}
TOUCHSTONE_INLINE void store(float* eight, const FloatPack& a) {
  for (int i = 0; i < kFloatLanes; ++i) eight[i] = a.lanes[i];
}
TOUCHSTONE_INLINE FloatPack load_eight(const float* eight) {
  return each_float_lane([&](int i) { return eight[i]; });
}
TOUCHSTONE_INLINE FloatPack load(const std::int16_t* eight) {
  return each_float_lane([&](int i) { return static_cast<float>(eight[i]); });
}
TOUCHSTONE_INLINE FloatPack load(const std::uint16_t* eight) {
  return each_float_lane([&](int i) { return static_cast<float>(eight[i]); });
}
TOUCHSTONE_INLINE FloatPack operator+(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] + b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack operator-(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] - b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack operator*(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] * b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack operator/(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] / b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack square_root(const FloatPack& a) {
  return each_float_lane([&](int i) { return std::sqrt(a.lanes[i]); });
}
TOUCHSTONE_INLINE FloatPack minimum(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] < b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack maximum(const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return a.lanes[i] > b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
}
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  return each_float_lane([&](int i) { return std::signbit(condition.lanes[i]) ? a.lanes[i] : b.lanes[i]; });
}
TOUCHSTONE_INLINE unsigned negative_lanes(const FloatPack& a) {
  unsigned bits = 0;
  for (int i = 0; i < kFloatLanes; ++i) bits |= (std::signbit(a.lanes[i]) ? 1U : 0U) << i;
  return bits;
}

#endif

#if !defined(__AVX2__)
TOUCHSTONE_INLINE float least_of_first(const FloatPack& a, unsigned count) {
  float lanes[kFloatLanes];
  store(lanes, a);
  float least = lanes[0];
  for (unsigned i = 1; i < count; ++i) least = lanes[i] < least ? lanes[i] : least;
  return least;
}
#endif

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "geometry/floating_point.h"
#include "robust/filtered/detail/target.h"
#include "robust/filtered/detail/vector3.h"

/// Four doubles that are processed together, in the vector registers of the target: one of AVX, two of SSE2, or plain
/// doubles.
///
/// `next_of_three` moves lanes 1, 2, 0, 1 to lanes 0, 1, 2, 3: the successor of each corner of a triangle.
/// `previous_of_three` moves lanes 2, 0, 1, 2 there: the predecessor.
///
/// + - * /, `minimum`, `maximum` and `square_root` work lane by lane. Sums of products are fused if the target can;
/// then values differ between targets, within the bounds of bounds.h. The truth value of a lane is its sign bit: x - y
/// has it set where x < y.
/// &, | and ^ combine such bits, and `negative_lanes` returns them.
namespace touchstone::filtered {
inline namespace TOUCHSTONE_TARGET {

#define TOUCHSTONE_INLINE inline __attribute__((always_inline))

inline constexpr int kLanes = 4;

#if defined(__AVX__)

struct Pack {
  __m256d lanes;
};
TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {_mm256_set_pd(d, c, b, a)}; }
TOUCHSTONE_INLINE Pack all_lanes(double value) { return {_mm256_set1_pd(value)}; }
TOUCHSTONE_INLINE Pack load(const double* four) { return {_mm256_loadu_pd(four)}; }
TOUCHSTONE_INLINE Pack load_three(const double* three) {
  return {_mm256_maskload_pd(three, _mm256_set_epi64x(0, -1, -1, -1))};
}
TOUCHSTONE_INLINE Pack load(const float* four) { return {_mm256_cvtps_pd(_mm_loadu_ps(four))}; }
TOUCHSTONE_INLINE void store(double* four, const Pack& a) { _mm256_storeu_pd(four, a.lanes); }
TOUCHSTONE_INLINE Pack operator+(const Pack& a, const Pack& b) { return {_mm256_add_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator-(const Pack& a, const Pack& b) { return {_mm256_sub_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator*(const Pack& a, const Pack& b) { return {_mm256_mul_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator/(const Pack& a, const Pack& b) { return {_mm256_div_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator&(const Pack& a, const Pack& b) { return {_mm256_and_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator|(const Pack& a, const Pack& b) { return {_mm256_or_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack operator^(const Pack& a, const Pack& b) { return {_mm256_xor_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack minimum(const Pack& a, const Pack& b) { return {_mm256_min_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack maximum(const Pack& a, const Pack& b) { return {_mm256_max_pd(a.lanes, b.lanes)}; }
TOUCHSTONE_INLINE Pack magnitude(const Pack& a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lanes)}; }
TOUCHSTONE_INLINE Pack square_root(const Pack& a) { return {_mm256_sqrt_pd(a.lanes)}; }
TOUCHSTONE_INLINE unsigned negative_lanes(const Pack& a) { return static_cast<unsigned>(_mm256_movemask_pd(a.lanes)); }
#if defined(__AVX2__)
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) { return {_mm256_permute4x64_pd(a.lanes, 0b01'00'10'01)}; }
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) { return {_mm256_permute4x64_pd(a.lanes, 0b10'01'00'10)}; }
#else
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) {
  const __m128d low = _mm256_castpd256_pd128(a.lanes);
  return {_mm256_set_m128d(low, _mm_shuffle_pd(low, _mm256_extractf128_pd(a.lanes, 1), 0b01))};
}
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) { return next_of_three(next_of_three(a)); }
#endif

/// Loads the coordinates of three points: lanes 0, 1, 2 of x, y, z belong to points 0, 1, 2; lane 3 holds any
/// coordinate.
TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  const __m256d first = _mm256_loadu_pd(nine), second = _mm256_loadu_pd(nine + 3);
  const __m256d xz = _mm256_unpacklo_pd(first, second), y_only = _mm256_unpackhi_pd(first, second);
  x = {_mm256_insertf128_pd(xz, _mm_loadu_pd(nine + 6), 1)};
  const __m128d yz = _mm_loadu_pd(nine + 7);
  y = {_mm256_insertf128_pd(y_only, yz, 1)};
  z = {_mm256_permute2f128_pd(xz, _mm256_castpd128_pd256(_mm_permute_pd(yz, 0b01)), 0x21)};
}

#if defined(__FMA__)
TOUCHSTONE_INLINE Pack multiply_add(const Pack& a, const Pack& b, const Pack& c) {
  return {_mm256_fmadd_pd(a.lanes, b.lanes, c.lanes)};
}
TOUCHSTONE_INLINE Pack multiply_subtract(const Pack& a, const Pack& b, const Pack& c) {
  return {_mm256_fmsub_pd(a.lanes, b.lanes, c.lanes)};
}
#endif

#elif defined(__SSE2__)

struct Pack {
  __m128d low, high;
};
TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {_mm_set_pd(b, a), _mm_set_pd(d, c)}; }
TOUCHSTONE_INLINE Pack all_lanes(double value) { return {_mm_set1_pd(value), _mm_set1_pd(value)}; }
TOUCHSTONE_INLINE Pack load(const double* four) { return {_mm_loadu_pd(four), _mm_loadu_pd(four + 2)}; }
TOUCHSTONE_INLINE Pack load_three(const double* three) { return {_mm_loadu_pd(three), _mm_load_sd(three + 2)}; }
TOUCHSTONE_INLINE Pack load(const float* four) {
  const __m128 floats = _mm_loadu_ps(four);
  return {_mm_cvtps_pd(floats), _mm_cvtps_pd(_mm_movehl_ps(floats, floats))};
}
TOUCHSTONE_INLINE void store(double* four, const Pack& a) {
  _mm_storeu_pd(four, a.low);
  _mm_storeu_pd(four + 2, a.high);
}
TOUCHSTONE_INLINE Pack operator+(const Pack& a, const Pack& b) {
  return {_mm_add_pd(a.low, b.low), _mm_add_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator-(const Pack& a, const Pack& b) {
  return {_mm_sub_pd(a.low, b.low), _mm_sub_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator*(const Pack& a, const Pack& b) {
  return {_mm_mul_pd(a.low, b.low), _mm_mul_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator/(const Pack& a, const Pack& b) {
  return {_mm_div_pd(a.low, b.low), _mm_div_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator&(const Pack& a, const Pack& b) {
  return {_mm_and_pd(a.low, b.low), _mm_and_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator|(const Pack& a, const Pack& b) {
  return {_mm_or_pd(a.low, b.low), _mm_or_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack operator^(const Pack& a, const Pack& b) {
  return {_mm_xor_pd(a.low, b.low), _mm_xor_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack minimum(const Pack& a, const Pack& b) {
  return {_mm_min_pd(a.low, b.low), _mm_min_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack maximum(const Pack& a, const Pack& b) {
  return {_mm_max_pd(a.low, b.low), _mm_max_pd(a.high, b.high)};
}
TOUCHSTONE_INLINE Pack magnitude(const Pack& a) {
  return {_mm_andnot_pd(_mm_set1_pd(-0.0), a.low), _mm_andnot_pd(_mm_set1_pd(-0.0), a.high)};
}
TOUCHSTONE_INLINE Pack square_root(const Pack& a) { return {_mm_sqrt_pd(a.low), _mm_sqrt_pd(a.high)}; }
TOUCHSTONE_INLINE unsigned negative_lanes(const Pack& a) {
  return static_cast<unsigned>(_mm_movemask_pd(a.low) | _mm_movemask_pd(a.high) << 2);
}
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) { return {_mm_shuffle_pd(a.low, a.high, 0b01), a.low}; }
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) {
  return {_mm_shuffle_pd(a.high, a.low, 0b00), _mm_shuffle_pd(a.low, a.high, 0b01)};
}

TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  const __m128d c = _mm_loadu_pd(nine + 7);
  x = {_mm_set_pd(nine[3], nine[0]), _mm_load_pd1(nine + 6)};
  y = {_mm_set_pd(nine[4], nine[1]), c};
  z = {_mm_set_pd(nine[5], nine[2]), _mm_unpackhi_pd(c, c)};
}

#else

struct Pack {
  double lanes[kLanes];
};
template <class F>
TOUCHSTONE_INLINE Pack each_lane(F f) {
  return {{f(0), f(1), f(2), f(3)}};
}
TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {{a, b, c, d}}; }
TOUCHSTONE_INLINE Pack all_lanes(double value) { return {{value, value, value, value}}; }
TOUCHSTONE_INLINE Pack load(const double* four) {
  return each_lane([&](int i) { return four[i]; });
}
TOUCHSTONE_INLINE Pack load_three(const double* three) { return {{three[0], three[1], three[2], 0}}; }
TOUCHSTONE_INLINE Pack load(const float* four) {
  return each_lane([&](int i) { return static_cast<double>(four[i]); });
}
TOUCHSTONE_INLINE void store(double* four, const Pack& a) {
  for (int i = 0; i < kLanes; ++i) four[i] = a.lanes[i];
}
TOUCHSTONE_INLINE Pack operator+(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] + b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack operator-(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] - b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack operator*(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] * b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack operator/(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] / b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack operator&(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return std::signbit(a.lanes[i]) && std::signbit(b.lanes[i]) ? -1.0 : 1.0; });
}
TOUCHSTONE_INLINE Pack operator|(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return std::signbit(a.lanes[i]) || std::signbit(b.lanes[i]) ? -1.0 : 1.0; });
}
TOUCHSTONE_INLINE Pack operator^(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return std::signbit(a.lanes[i]) != std::signbit(b.lanes[i]) ? -1.0 : 1.0; });
}
TOUCHSTONE_INLINE Pack minimum(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] < b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack maximum(const Pack& a, const Pack& b) {
  return each_lane([&](int i) { return a.lanes[i] > b.lanes[i] ? a.lanes[i] : b.lanes[i]; });
}
TOUCHSTONE_INLINE Pack magnitude(const Pack& a) {
  return each_lane([&](int i) { return std::abs(a.lanes[i]); });
}
TOUCHSTONE_INLINE Pack square_root(const Pack& a) {
  return each_lane([&](int i) { return std::sqrt(a.lanes[i]); });
}
TOUCHSTONE_INLINE unsigned negative_lanes(const Pack& a) {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= (std::signbit(a.lanes[i]) ? 1U : 0U) << i;
  return bits;
}
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) { return pack(a.lanes[1], a.lanes[2], a.lanes[0], a.lanes[1]); }
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) { return pack(a.lanes[2], a.lanes[0], a.lanes[1], a.lanes[2]); }
TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  x = pack(nine[0], nine[3], nine[6], nine[0]);
  y = pack(nine[1], nine[4], nine[7], nine[1]);
  z = pack(nine[2], nine[5], nine[8], nine[2]);
}

#endif

#if !defined(__FMA__)
TOUCHSTONE_INLINE Pack multiply_add(const Pack& a, const Pack& b, const Pack& c) { return a * b + c; }
TOUCHSTONE_INLINE Pack multiply_subtract(const Pack& a, const Pack& b, const Pack& c) { return a * b - c; }
#endif

TOUCHSTONE_INLINE Pack dot(const Vector3<Pack>& a, const Vector3<Pack>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}
TOUCHSTONE_INLINE Vector3<Pack> cross(const Vector3<Pack>& a, const Vector3<Pack>& b) {
  return {multiply_subtract(a.y, b.z, a.z * b.y), multiply_subtract(a.z, b.x, a.x * b.z),
          multiply_subtract(a.x, b.y, a.y * b.x)};
}

TOUCHSTONE_INLINE Vector3<Pack> difference(const Vector3<Pack>& a, const Vector3<Pack>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Returns the largest magnitude of a component.
TOUCHSTONE_INLINE Pack largest_component(const Vector3<Pack>& v) {
  return maximum(maximum(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::filtered

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "geometry/floating_point.h"
#include "robust/filtered/detail/numbers/target.h"
#include "robust/filtered/detail/numbers/vector3.h"

/// Four doubles or eight floats that are processed together, in the vector registers of the target: one of AVX2, two of
/// SSE2, or plain numbers.
///
/// + - * /, `minimum`, `maximum` and `square_root` work lane by lane. minimum(a, b) and maximum(a, b) are b where a is
/// not a number. Sums of products are fused if the target can; then values differ between targets, within the bounds of
/// bounds.h. The truth value of a lane is its sign bit: x - y has it set where x < y. &, | and ^ combine such bits, and
/// `negative_lanes` returns them.
namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

#define TOUCHSTONE_INLINE inline __attribute__((always_inline))

// A register of the target and its instructions: all that depends on the target, except loads, shuffles and fused
// products, which follow below.
#if defined(__AVX2__)

template <class T>
struct Register;
template <>
struct Register<double> {
  using Type = __m256d;
  static TOUCHSTONE_INLINE Type all(double value) { return _mm256_set1_pd(value); }
  static TOUCHSTONE_INLINE Type load(const double* from) { return _mm256_loadu_pd(from); }
  static TOUCHSTONE_INLINE void store(double* to, Type a) { _mm256_storeu_pd(to, a); }
  static TOUCHSTONE_INLINE Type both(Type a, Type b) { return _mm256_and_pd(a, b); }
  static TOUCHSTONE_INLINE Type either(Type a, Type b) { return _mm256_or_pd(a, b); }
  static TOUCHSTONE_INLINE Type one_of(Type a, Type b) { return _mm256_xor_pd(a, b); }
  static TOUCHSTONE_INLINE Type minimum(Type a, Type b) { return _mm256_min_pd(a, b); }
  static TOUCHSTONE_INLINE Type maximum(Type a, Type b) { return _mm256_max_pd(a, b); }
  static TOUCHSTONE_INLINE Type magnitude(Type a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
  static TOUCHSTONE_INLINE Type square_root(Type a) { return _mm256_sqrt_pd(a); }
  static TOUCHSTONE_INLINE int signs(Type a) { return _mm256_movemask_pd(a); }
};
template <>
struct Register<float> {
  using Type = __m256;
  static TOUCHSTONE_INLINE Type all(float value) { return _mm256_set1_ps(value); }
  static TOUCHSTONE_INLINE Type load(const float* from) { return _mm256_loadu_ps(from); }
  static TOUCHSTONE_INLINE void store(float* to, Type a) { _mm256_storeu_ps(to, a); }
  static TOUCHSTONE_INLINE Type minimum(Type a, Type b) { return _mm256_min_ps(a, b); }
  static TOUCHSTONE_INLINE Type maximum(Type a, Type b) { return _mm256_max_ps(a, b); }
  static TOUCHSTONE_INLINE Type square_root(Type a) { return _mm256_sqrt_ps(a); }
  static TOUCHSTONE_INLINE int signs(Type a) { return _mm256_movemask_ps(a); }
};

#elif defined(__SSE2__)

template <class T>
struct Register;
template <>
struct Register<double> {
  using Type = __m128d;
  static TOUCHSTONE_INLINE Type all(double value) { return _mm_set1_pd(value); }
  static TOUCHSTONE_INLINE Type load(const double* from) { return _mm_loadu_pd(from); }
  static TOUCHSTONE_INLINE void store(double* to, Type a) { _mm_storeu_pd(to, a); }
  static TOUCHSTONE_INLINE Type both(Type a, Type b) { return _mm_and_pd(a, b); }
  static TOUCHSTONE_INLINE Type either(Type a, Type b) { return _mm_or_pd(a, b); }
  static TOUCHSTONE_INLINE Type one_of(Type a, Type b) { return _mm_xor_pd(a, b); }
  static TOUCHSTONE_INLINE Type minimum(Type a, Type b) { return _mm_min_pd(a, b); }
  static TOUCHSTONE_INLINE Type maximum(Type a, Type b) { return _mm_max_pd(a, b); }
  static TOUCHSTONE_INLINE Type magnitude(Type a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a); }
  static TOUCHSTONE_INLINE Type square_root(Type a) { return _mm_sqrt_pd(a); }
  static TOUCHSTONE_INLINE int signs(Type a) { return _mm_movemask_pd(a); }
};
template <>
struct Register<float> {
  using Type = __m128;
  static TOUCHSTONE_INLINE Type all(float value) { return _mm_set1_ps(value); }
  static TOUCHSTONE_INLINE Type load(const float* from) { return _mm_loadu_ps(from); }
  static TOUCHSTONE_INLINE void store(float* to, Type a) { _mm_storeu_ps(to, a); }
  static TOUCHSTONE_INLINE Type minimum(Type a, Type b) { return _mm_min_ps(a, b); }
  static TOUCHSTONE_INLINE Type maximum(Type a, Type b) { return _mm_max_ps(a, b); }
  static TOUCHSTONE_INLINE Type square_root(Type a) { return _mm_sqrt_ps(a); }
  static TOUCHSTONE_INLINE int signs(Type a) { return _mm_movemask_ps(a); }
};

#else

template <class T>
struct Register {
  using Type = T;
  static TOUCHSTONE_INLINE T all(T value) { return value; }
  static TOUCHSTONE_INLINE T load(const T* from) { return *from; }
  static TOUCHSTONE_INLINE void store(T* to, T a) { *to = a; }
  static TOUCHSTONE_INLINE T truth(bool value) { return value ? T{-1} : T{1}; }
  static TOUCHSTONE_INLINE T both(T a, T b) { return truth(std::signbit(a) && std::signbit(b)); }
  static TOUCHSTONE_INLINE T either(T a, T b) { return truth(std::signbit(a) || std::signbit(b)); }
  static TOUCHSTONE_INLINE T one_of(T a, T b) { return truth(std::signbit(a) != std::signbit(b)); }
  static TOUCHSTONE_INLINE T minimum(T a, T b) { return a < b ? a : b; }
  static TOUCHSTONE_INLINE T maximum(T a, T b) { return a > b ? a : b; }
  static TOUCHSTONE_INLINE T magnitude(T a) { return std::abs(a); }
  static TOUCHSTONE_INLINE T square_root(T a) { return std::sqrt(a); }
  static TOUCHSTONE_INLINE int signs(T a) { return std::signbit(a) ? 1 : 0; }
};

#endif

#if defined(__FMA__)
TOUCHSTONE_INLINE __m128d fused_sum(__m128d a, __m128d b, __m128d c) { return _mm_fmadd_pd(a, b, c); }
TOUCHSTONE_INLINE __m256d fused_sum(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
TOUCHSTONE_INLINE __m128 fused_sum(__m128 a, __m128 b, __m128 c) { return _mm_fmadd_ps(a, b, c); }
TOUCHSTONE_INLINE __m256 fused_sum(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
TOUCHSTONE_INLINE __m128d fused_difference(__m128d a, __m128d b, __m128d c) { return _mm_fmsub_pd(a, b, c); }
TOUCHSTONE_INLINE __m256d fused_difference(__m256d a, __m256d b, __m256d c) { return _mm256_fmsub_pd(a, b, c); }
TOUCHSTONE_INLINE __m128 fused_difference(__m128 a, __m128 b, __m128 c) { return _mm_fmsub_ps(a, b, c); }
TOUCHSTONE_INLINE __m256 fused_difference(__m256 a, __m256 b, __m256 c) { return _mm256_fmsub_ps(a, b, c); }
#elif defined(TOUCHSTONE_FUSED)
template <class T>
TOUCHSTONE_INLINE T fused_sum(T a, T b, T c) {
  return std::fma(a, b, c);
}
template <class T>
TOUCHSTONE_INLINE T fused_difference(T a, T b, T c) {
  return std::fma(a, b, -c);
}
#endif

template <class T, int N>
struct Lanes {
  using Part = Register<T>;
  static constexpr int kParts = N * sizeof(T) / sizeof(typename Part::Type), kLanesOfPart = N / kParts;
  typename Part::Type parts[kParts];

  /// Returns the lanes whose part i is f(i).
  template <class F>
  static TOUCHSTONE_INLINE Lanes each(const F& f) {
    if constexpr (kParts == 1)
      return {{f(0)}};
    else if constexpr (kParts == 2)
      return {{f(0), f(1)}};
    else if constexpr (kParts == 4)
      return {{f(0), f(1), f(2), f(3)}};
    else
      return {{f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)}};
  }
  static TOUCHSTONE_INLINE Lanes all(T value) {
    return each([&](int) { return Part::all(value); });
  }
  static TOUCHSTONE_INLINE Lanes load(const T* from) {
    return each([&](int i) { return Part::load(from + i * kLanesOfPart); });
  }
  friend TOUCHSTONE_INLINE void store(T* to, const Lanes& a) {
    for (int i = 0; i < kParts; ++i) Part::store(to + i * kLanesOfPart, a.parts[i]);
  }
  friend TOUCHSTONE_INLINE unsigned negative_lanes(const Lanes& a) {
    int bits = Part::signs(a.parts[0]);
    for (int i = 1; i < kParts; ++i) bits |= Part::signs(a.parts[i]) << i * kLanesOfPart;
    return static_cast<unsigned>(bits);
  }

  friend TOUCHSTONE_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return a.parts[i] + b.parts[i]; });
  }
  friend TOUCHSTONE_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return a.parts[i] - b.parts[i]; });
  }
  friend TOUCHSTONE_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return a.parts[i] * b.parts[i]; });
  }
  friend TOUCHSTONE_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return a.parts[i] / b.parts[i]; });
  }
  friend TOUCHSTONE_INLINE Lanes operator&(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return Part::both(a.parts[i], b.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes operator|(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return Part::either(a.parts[i], b.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes operator^(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return Part::one_of(a.parts[i], b.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes minimum(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return Part::minimum(a.parts[i], b.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes maximum(const Lanes& a, const Lanes& b) {
    return each([&](int i) { return Part::maximum(a.parts[i], b.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes magnitude(const Lanes& a) {
    return each([&](int i) { return Part::magnitude(a.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes square_root(const Lanes& a) {
    return each([&](int i) { return Part::square_root(a.parts[i]); });
  }
#if defined(TOUCHSTONE_FUSED)
  friend TOUCHSTONE_INLINE Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
    return each([&](int i) { return fused_sum(a.parts[i], b.parts[i], c.parts[i]); });
  }
  friend TOUCHSTONE_INLINE Lanes multiply_subtract(const Lanes& a, const Lanes& b, const Lanes& c) {
    return each([&](int i) { return fused_difference(a.parts[i], b.parts[i], c.parts[i]); });
  }
#endif
};

inline constexpr int kLanes = 4, kFloatLanes = 8;
using Pack = Lanes<double, kLanes>;
using FloatPack = Lanes<float, kFloatLanes>;

TOUCHSTONE_INLINE Pack all_lanes(double value) { return Pack::all(value); }
TOUCHSTONE_INLINE FloatPack all_float_lanes(float value) { return FloatPack::all(value); }
TOUCHSTONE_INLINE Pack load(const double* four) { return Pack::load(four); }
TOUCHSTONE_INLINE FloatPack load_eight(const float* eight) { return FloatPack::load(eight); }

// pack(a, b, c, d) has these lanes. load_three(three) loads lanes 0 to 2.
//
// `next_of_three` moves lanes 1, 2, 0, 1 to lanes 0, 1, 2, 3: the successor of each corner of a triangle.
// `previous_of_three` moves lanes 2, 0, 1, 2 there: the predecessor.
//
// `load_three_points` loads the coordinates of three points: lanes 0, 1, 2 of x, y, z belong to points 0, 1, 2; lane 3
// holds any coordinate. Integers are loaded from addresses that are multiples of 16.
//
// transpose(a, b, c, d) makes packs of the lanes 0, 1, 2 and 3 of four packs. nearest_floats(a, b) has the floats
// nearest to the lanes of a and, after them, to those of b.
//
// select(condition, a, b) is a where `condition` is true, and b elsewhere. least_of_first(a, count) is the least number
// of the first `count` lanes, which is from 1 to 8; requires numbers.
#if defined(__AVX2__)

TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {{_mm256_set_pd(d, c, b, a)}}; }
TOUCHSTONE_INLINE Pack load_three(const double* three) {
  return {{_mm256_maskload_pd(three, _mm256_set_epi64x(0, -1, -1, -1))}};
}
TOUCHSTONE_INLINE Pack load(const float* four) { return {{_mm256_cvtps_pd(_mm_loadu_ps(four))}}; }
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) { return {{_mm256_permute4x64_pd(a.parts[0], 0b01'00'10'01)}}; }
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) { return {{_mm256_permute4x64_pd(a.parts[0], 0b10'01'00'10)}}; }
TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  const __m256d first = _mm256_loadu_pd(nine), second = _mm256_loadu_pd(nine + 3);
  const __m256d xz = _mm256_unpacklo_pd(first, second), y_only = _mm256_unpackhi_pd(first, second);
  x = {{_mm256_insertf128_pd(xz, _mm_loadu_pd(nine + 6), 1)}};
  const __m128d yz = _mm_loadu_pd(nine + 7);
  y = {{_mm256_insertf128_pd(y_only, yz, 1)}};
  z = {{_mm256_permute2f128_pd(xz, _mm256_castpd128_pd256(_mm_permute_pd(yz, 0b01)), 0x21)}};
}
TOUCHSTONE_INLINE void transpose(Pack& a, Pack& b, Pack& c, Pack& d) {
  const __m256d ab_even = _mm256_unpacklo_pd(a.parts[0], b.parts[0]),
                ab_odd = _mm256_unpackhi_pd(a.parts[0], b.parts[0]);
  const __m256d cd_even = _mm256_unpacklo_pd(c.parts[0], d.parts[0]),
                cd_odd = _mm256_unpackhi_pd(c.parts[0], d.parts[0]);
  a = {{_mm256_permute2f128_pd(ab_even, cd_even, 0x20)}};
  b = {{_mm256_permute2f128_pd(ab_odd, cd_odd, 0x20)}};
  c = {{_mm256_permute2f128_pd(ab_even, cd_even, 0x31)}};
  d = {{_mm256_permute2f128_pd(ab_odd, cd_odd, 0x31)}};
}
TOUCHSTONE_INLINE FloatPack nearest_floats(const Pack& a, const Pack& b) {
  return {{_mm256_set_m128(_mm256_cvtpd_ps(b.parts[0]), _mm256_cvtpd_ps(a.parts[0]))}};
}
TOUCHSTONE_INLINE FloatPack load(const std::int16_t* eight) {
  return {{_mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(eight))))}};
}
TOUCHSTONE_INLINE FloatPack load(const std::uint16_t* eight) {
  return {{_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_load_si128(reinterpret_cast<const __m128i*>(eight))))}};
}
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  return {{_mm256_blendv_ps(b.parts[0], a.parts[0], condition.parts[0])}};
}
TOUCHSTONE_INLINE float least_of_first(const FloatPack& a, unsigned count) {
  const __m256i lane = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
  // Lane 0 in place of the lanes that do not count.
  const __m256i in = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(count)), lane);
  const __m256 all = _mm256_permutevar8x32_ps(a.parts[0], _mm256_and_si256(in, lane));
  const __m128 four = _mm_min_ps(_mm256_castps256_ps128(all), _mm256_extractf128_ps(all, 1));
  const __m128 two = _mm_min_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)));
}

#elif defined(__SSE2__)

TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {{_mm_set_pd(b, a), _mm_set_pd(d, c)}}; }
TOUCHSTONE_INLINE Pack load_three(const double* three) { return {{_mm_loadu_pd(three), _mm_load_sd(three + 2)}}; }
TOUCHSTONE_INLINE Pack load(const float* four) {
  const __m128 floats = _mm_loadu_ps(four);
  return {{_mm_cvtps_pd(floats), _mm_cvtps_pd(_mm_movehl_ps(floats, floats))}};
}
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) {
  return {{_mm_shuffle_pd(a.parts[0], a.parts[1], 0b01), a.parts[0]}};
}
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) {
  return {{_mm_shuffle_pd(a.parts[1], a.parts[0], 0b00), _mm_shuffle_pd(a.parts[0], a.parts[1], 0b01)}};
}
TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  const __m128d c = _mm_loadu_pd(nine + 7);
  x = {{_mm_set_pd(nine[3], nine[0]), _mm_load_pd1(nine + 6)}};
  y = {{_mm_set_pd(nine[4], nine[1]), c}};
  z = {{_mm_set_pd(nine[5], nine[2]), _mm_unpackhi_pd(c, c)}};
}
TOUCHSTONE_INLINE FloatPack load(const std::int16_t* eight) {
  const __m128i integers = _mm_load_si128(reinterpret_cast<const __m128i*>(eight));
  // Each integer in the upper half of 32 bits, then shifted down with its sign.
  const __m128i low = _mm_srai_epi32(_mm_unpacklo_epi16(integers, integers), 16);
  const __m128i high = _mm_srai_epi32(_mm_unpackhi_epi16(integers, integers), 16);
  return {{_mm_cvtepi32_ps(low), _mm_cvtepi32_ps(high)}};
}
TOUCHSTONE_INLINE FloatPack load(const std::uint16_t* eight) {
  const __m128i integers = _mm_load_si128(reinterpret_cast<const __m128i*>(eight)), zero = _mm_setzero_si128();
  return {{_mm_cvtepi32_ps(_mm_unpacklo_epi16(integers, zero)), _mm_cvtepi32_ps(_mm_unpackhi_epi16(integers, zero))}};
}
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  return FloatPack::each([&](int i) {
    const __m128 chosen = _mm_castsi128_ps(_mm_srai_epi32(_mm_castps_si128(condition.parts[i]), 31));
    return _mm_or_ps(_mm_and_ps(chosen, a.parts[i]), _mm_andnot_ps(chosen, b.parts[i]));
  });
}

#else

TOUCHSTONE_INLINE Pack pack(double a, double b, double c, double d) { return {{a, b, c, d}}; }
TOUCHSTONE_INLINE Pack load_three(const double* three) { return {{three[0], three[1], three[2], 0}}; }
TOUCHSTONE_INLINE Pack load(const float* four) {
  return Pack::each([&](int i) { return static_cast<double>(four[i]); });
}
TOUCHSTONE_INLINE Pack next_of_three(const Pack& a) { return pack(a.parts[1], a.parts[2], a.parts[0], a.parts[1]); }
TOUCHSTONE_INLINE Pack previous_of_three(const Pack& a) { return pack(a.parts[2], a.parts[0], a.parts[1], a.parts[2]); }
TOUCHSTONE_INLINE void load_three_points(const double* nine, Pack& x, Pack& y, Pack& z) {
  x = pack(nine[0], nine[3], nine[6], nine[0]);
  y = pack(nine[1], nine[4], nine[7], nine[1]);
  z = pack(nine[2], nine[5], nine[8], nine[2]);
}
template <class Integer>
TOUCHSTONE_INLINE FloatPack load(const Integer* eight) {
  return FloatPack::each([&](int i) { return static_cast<float>(eight[i]); });
}
TOUCHSTONE_INLINE FloatPack select(const FloatPack& condition, const FloatPack& a, const FloatPack& b) {
  return FloatPack::each([&](int i) { return std::signbit(condition.parts[i]) ? a.parts[i] : b.parts[i]; });
}

#endif

#if !defined(__AVX2__)
TOUCHSTONE_INLINE void transpose(Pack& a, Pack& b, Pack& c, Pack& d) {
  double rows[kLanes][kLanes];
  store(rows[0], a), store(rows[1], b), store(rows[2], c), store(rows[3], d);
  const auto column = [&rows](int i) { return pack(rows[0][i], rows[1][i], rows[2][i], rows[3][i]); };
  a = column(0), b = column(1), c = column(2), d = column(3);
}
TOUCHSTONE_INLINE FloatPack nearest_floats(const Pack& a, const Pack& b) {
  double given[kFloatLanes];
  store(given, a), store(given + kLanes, b);
  float nearest[kFloatLanes];
  for (int i = 0; i < kFloatLanes; ++i) nearest[i] = static_cast<float>(given[i]);
  return load_eight(nearest);
}
TOUCHSTONE_INLINE float least_of_first(const FloatPack& a, unsigned count) {
  float lanes[kFloatLanes];
  store(lanes, a);
  float least = lanes[0];
  for (unsigned i = 1; i < count; ++i) least = lanes[i] < least ? lanes[i] : least;
  return least;
}
#endif

template <class T, int N>
TOUCHSTONE_INLINE Lanes<T, N> dot(const Vector3<Lanes<T, N>>& a, const Vector3<Lanes<T, N>>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}
template <class T, int N>
TOUCHSTONE_INLINE Vector3<Lanes<T, N>> cross(const Vector3<Lanes<T, N>>& a, const Vector3<Lanes<T, N>>& b) {
  return {multiply_subtract(a.y, b.z, a.z * b.y), multiply_subtract(a.z, b.x, a.x * b.z),
          multiply_subtract(a.x, b.y, a.y * b.x)};
}

template <class T, int N>
TOUCHSTONE_INLINE Vector3<Lanes<T, N>> difference(const Vector3<Lanes<T, N>>& a, const Vector3<Lanes<T, N>>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

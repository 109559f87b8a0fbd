// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "robust/filtered/detail/numbers/target.h"

namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET {

__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;

/// Returns whether the double is an integer.
inline bool is_integer(double value) {
  // From 2^53 on every double is an integer.
  return std::abs(value) >= 0x1p53 || static_cast<double>(static_cast<std::int64_t>(value)) == value;  // exact
}

/// An integer of magnitude below 2^Bits, in as few 64-bit words as possible.
///
/// The type of a sum or product is wide enough for every value it can take, so nothing overflows and nothing is
/// checked at run time: sums have one bit more than their larger term, products the bits of both factors.
template <int Bits>
class Integer {
 public:
  static constexpr int words = Bits / 64 + 1;
  using Storage = std::conditional_t<(Bits < 64), std::int64_t,
                                     std::conditional_t<(Bits < 128), Int128, std::array<std::uint64_t, words>>>;

  constexpr Integer() : storage_{} {}
  /// Requires |value| < 2^Bits.
  constexpr explicit Integer(Storage value) : storage_(value) {}

  [[nodiscard]] constexpr const Storage& storage() const { return storage_; }

  /// Two's complement, least significant word first; `Size` words hold it.
  template <int Size>
  [[nodiscard]] constexpr std::array<std::uint64_t, Size> extended() const {
    std::array<std::uint64_t, Size> result{};
    if constexpr (Bits < 128) {
      const Int128 value = storage_;
      for (int i = 0; i < Size; ++i)
        result[static_cast<std::size_t>(i)] = static_cast<std::uint64_t>(i < 2 ? value >> (64 * i) : value >> 127);
    } else {
      for (std::size_t i = 0; i < Size; ++i)
        result[i] = i < storage_.size() ? storage_[i] : (negative() ? ~std::uint64_t{0} : 0);
    }
    return result;
  }

  [[nodiscard]] constexpr bool negative() const {
    if constexpr (Bits < 128)
      return storage_ < 0;
    else
      return (storage_.back() >> 63) != 0;
  }
  [[nodiscard]] constexpr int sign() const {
    if (negative()) return -1;
    return storage_ == Storage{} ? 0 : 1;
  }

 private:
  Storage storage_;
};

/// Returns the number in fewer bits. Requires |number| < 2^To.
template <int To, int From>
constexpr Integer<To> narrowed(const Integer<From>& number) {
  if constexpr (To >= 128) {
    return Integer<To>(number.template extended<Integer<To>::words>());
  } else {
    const auto words = number.template extended<2>();
    return Integer<To>(static_cast<typename Integer<To>::Storage>(Uint128{words[1]} << 64 | words[0]));
  }
}

/// a + b, or a - b where Negative.
template <bool Negative, int A, int B>
constexpr auto sum(const Integer<A>& a, const Integer<B>& b) {
  using Result = Integer<std::max(A, B) + 1>;
  using Storage = typename Result::Storage;
  if constexpr (Result::words <= 2) {
    const auto x = static_cast<Storage>(a.storage()), y = static_cast<Storage>(b.storage());
    return Result(Negative ? x - y : x + y);
  } else {
    const auto x = a.template extended<Result::words>(), y = b.template extended<Result::words>();
    Storage result{};
    Uint128 carry = Negative ? 1 : 0;  // -y is ~y + 1
    for (std::size_t i = 0; i < result.size(); ++i) {
      carry += Uint128{x[i]} + (Negative ? ~y[i] : y[i]);
      result[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return Result(result);
  }
}
template <int A, int B>
constexpr auto operator+(const Integer<A>& a, const Integer<B>& b) {
  return sum<false>(a, b);
}
template <int A, int B>
constexpr auto operator-(const Integer<A>& a, const Integer<B>& b) {
  return sum<true>(a, b);
}

template <int A, int B>
constexpr auto operator*(const Integer<A>& a, const Integer<B>& b) {
  using Result = Integer<A + B>;
  using Storage = typename Result::Storage;
  if constexpr (Result::words <= 2) {
    return Result(static_cast<Storage>(a.storage()) * static_cast<Storage>(b.storage()));
  } else {
    // Schoolbook on the two's complements, modulo 2^(64 words): exact, as the product fits.
    const auto x = a.template extended<Result::words>(), y = b.template extended<Result::words>();
    Storage result{};
    for (std::size_t i = 0; i < result.size(); ++i) {
      Uint128 carry = 0;
      for (std::size_t j = 0; i + j < result.size(); ++j) {
        carry += Uint128{x[i]} * y[j] + result[i + j];
        result[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
    }
    return Result(result);
  }
}

}  // namespace touchstone::filtered::detail::inline TOUCHSTONE_TARGET

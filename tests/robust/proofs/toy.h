// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>

namespace touchstone::proofs {

enum class Rounding { Nearest, Down, Up, TowardZero };

/// The value with at most `bits` significant bits that is nearest to the integer (ties to even), or the next one in
/// the rounding's direction. Integers stay integers, so toy arithmetic needs nothing else.
constexpr std::int64_t rounded(std::int64_t exact, int bits, Rounding rounding) {
  const bool negative = exact < 0;
  const auto magnitude = static_cast<std::uint64_t>(negative ? -exact : exact);
  const int excess = static_cast<int>(std::bit_width(magnitude)) - bits;
  if (excess <= 0) return exact;
  const std::uint64_t step = std::uint64_t{1} << excess, tail = magnitude & (step - 1), below = magnitude - tail;
  const bool is_odd = (below & step) != 0;
  bool away = false;  // from zero
  switch (rounding) {
    case Rounding::Nearest: away = tail > step / 2 || (tail == step / 2 && is_odd); break;
    case Rounding::Down: away = negative && tail != 0; break;
    case Rounding::Up: away = !negative && tail != 0; break;
    case Rounding::TowardZero: break;
  }
  const auto result = static_cast<std::int64_t>(away ? below + step : below);
  return negative ? -result : result;
}

/// A floating-point number of few significant bits without limits of the exponent, whose value is an integer. Every
/// number computes with the bits and the rounding that were set last: templates over them would take a minute to
/// compile.
struct Toy {
  std::int64_t value;

  static Toy of(std::int64_t exact) { return {rounded(exact, bits, rounding)}; }
  friend Toy operator+(Toy a, Toy b) { return of(a.value + b.value); }
  friend Toy operator-(Toy a, Toy b) { return of(a.value - b.value); }
  friend Toy operator*(Toy a, Toy b) { return of(a.value * b.value); }
  friend bool operator==(Toy a, Toy b) = default;

  static void set_arithmetic(int new_bits, Rounding new_rounding) { bits = new_bits, rounding = new_rounding; }

 private:
  static inline int bits = 0;
  static inline Rounding rounding = Rounding::Nearest;
};

/// Calls visit(rounding) for each rounding, with toys of `bits` bits.
template <class Visit>
void for_each_rounding(int bits, Visit visit) {
  for (const Rounding rounding : {Rounding::Nearest, Rounding::Down, Rounding::Up, Rounding::TowardZero}) {
    Toy::set_arithmetic(bits, rounding);
    visit(rounding);
  }
}

/// Calls visit(bits, rounding) for each toy arithmetic.
template <class Visit>
void for_each_arithmetic(Visit visit) {
  for (int bits = 4; bits <= 8; ++bits) for_each_rounding(bits, [&](Rounding rounding) { visit(bits, rounding); });
}

/// A number with its permanent, as numbers/permanent.h, over any number type.
template <class Number>
struct WithPermanent {
  Number value, permanent;

  friend constexpr WithPermanent operator+(const WithPermanent& a, const WithPermanent& b) {
    return {a.value + b.value, a.permanent + b.permanent};
  }
  friend constexpr WithPermanent operator-(const WithPermanent& a, const WithPermanent& b) {
    return {a.value - b.value, a.permanent + b.permanent};
  }
  friend constexpr WithPermanent operator*(const WithPermanent& a, const WithPermanent& b) {
    return {a.value * b.value, a.permanent * b.permanent};
  }
};

}  // namespace touchstone::proofs

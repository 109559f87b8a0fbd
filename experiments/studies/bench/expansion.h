// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>

#include "robust/filtered/detail/numbers/double_double.h"

namespace touchstone::bench {
inline namespace TOUCHSTONE_TARGET {

/// A sum of doubles that do not overlap, in ascending order of magnitude: + - * are exact. No word is zero.
///
/// Requires round to nearest, and neither overflow nor underflow of any word. Source: [shewchuk1997].
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double value) { append(value); }

  void append(double word) {
    if (word != 0) words_.push_back({word});
  }
  [[nodiscard]] int size() const { return static_cast<int>(words_.size()); }
  [[nodiscard]] double word(int i) const { return words_[static_cast<std::size_t>(i)].value; }
  [[nodiscard]] int sign() const { return words_.empty() ? 0 : words_.back().value > 0 ? 1 : -1; }

 private:
  struct Word {  // a type of this target, so that no other target shares the functions of the vector
    double value;
  };
  boost::container::small_vector<Word, 64> words_;  // most fit, so that few queries allocate
};

/// Appends the sum of two expansions, the second times 1 or -1, to an empty one: fast_expansion_sum_zeroelim.
inline void add_to(Expansion& result, const Expansion& a, const Expansion& b, double factor) {
  int i = 0, j = 0;
  const auto next = [&] {
    const bool first = j == b.size() || (i < a.size() && std::abs(a.word(i)) < std::abs(b.word(j)));
    return first ? a.word(i++) : factor * b.word(j++);
  };
  if (a.size() + b.size() == 0) return;
  double carried = next();
  for (int left = a.size() + b.size() - 1; left > 0; --left) {
    const filtered::detail::DoubleDouble both = filtered::detail::two_sum(carried, next());
    result.append(both.low);
    carried = both.high;
  }
  result.append(carried);
}

inline Expansion operator+(const Expansion& a, const Expansion& b) {
  Expansion result;
  add_to(result, a, b, 1);
  return result;
}
inline Expansion operator-(const Expansion& a, const Expansion& b) {
  Expansion result;
  add_to(result, a, b, -1);
  return result;
}

/// Appends words first..last of a times b to an empty expansion: scale_expansion_zeroelim, the products added in pairs.
inline void multiply_to(Expansion& result, const Expansion& a, const Expansion& b, int first, int last) {
  if (last - first == 1) {
    const double factor = a.word(first);
    double carried = 0;
    for (int j = 0; j < b.size(); ++j) {
      const filtered::detail::DoubleDouble exact = filtered::detail::two_product(b.word(j), factor);
      const filtered::detail::DoubleDouble low = filtered::detail::two_sum(carried, exact.low);
      result.append(low.low);
      const filtered::detail::DoubleDouble high = filtered::detail::quick_two_sum(exact.high, low.high);
      result.append(high.low);
      carried = high.high;
    }
    result.append(carried);
    return;
  }
  const int middle = first + (last - first) / 2;
  Expansion lower, upper;
  multiply_to(lower, a, b, first, middle);
  multiply_to(upper, a, b, middle, last);
  Expansion sum;
  add_to(sum, lower, upper, 1);
  for (int i = 0; i < sum.size(); ++i) result.append(sum.word(i));
}

inline Expansion operator*(const Expansion& a, const Expansion& b) {
  Expansion result;
  if (a.size() == 0 || b.size() == 0) return result;
  // By the words of the shorter one.
  if (a.size() <= b.size())
    multiply_to(result, a, b, 0, a.size());
  else
    multiply_to(result, b, a, 0, b.size());
  return result;
}

/// Returns a - b.
inline Expansion exact_difference(double a, double b) {
  const filtered::detail::DoubleDouble difference = filtered::detail::two_difference(a, b);
  Expansion result;
  result.append(difference.low);
  result.append(difference.high);
  return result;
}

inline int sign(const Expansion& a) { return a.sign(); }

}  // namespace TOUCHSTONE_TARGET
}  // namespace touchstone::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "experiments/run/archive.h"

namespace touchstone::run {

/// A number that sums to the largest one.
template <class Number>
struct Maximum {
  Number value{};

  Maximum& operator+=(const Maximum& other) {
    value = std::max(value, other.value);
    return *this;
  }
  Maximum& operator+=(Number other) { return *this += Maximum{other}; }
  operator Number() const { return value; }  // NOLINT(google-explicit-constructor): it is used as the number
  auto members() { return std::tie(value); }
};

/// Adds the other value to the sum, member by member: numbers are added, arrays and vectors element by element (an
/// empty vector is zero), maps key by key. A type that has an operator += is added by it; another one has `members()`.
/// Requires vectors of the same size, or an empty one.
template <class T>
void add(T& sum, const T& other) {
  using namespace detail;
  if constexpr (requires { sum += other; } && !std::is_same_v<T, std::string>) {
    sum += other;
  } else if constexpr (is_array<T>) {
    for (std::size_t i = 0; i < sum.size(); ++i) add(sum[i], other[i]);
  } else if constexpr (is_vector<T>) {
    if (sum.empty()) sum.resize(other.size());
    for (std::size_t i = 0; i < other.size(); ++i) add(sum[i], other[i]);
  } else if constexpr (is_map<T>) {
    for (const auto& [key, value] : other) add(sum[key], value);
  } else {
    static_assert(HasMembers<T>, "give the type an operator += or a function members()");
    // members() may hand out references to members that are not const: these are only read.
    auto to = sum.members();
    const auto from = const_cast<T&>(other).members();
    [&]<std::size_t... I>(std::index_sequence<I...>) { (add(std::get<I>(to), std::as_const(std::get<I>(from))), ...); }
    (std::make_index_sequence<std::tuple_size_v<decltype(to)>>());
  }
}

}  // namespace touchstone::run

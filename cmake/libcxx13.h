// SPDX-License-Identifier: Apache-2.0
// What the library uses of C++20 and libc++ 13, the one of Debian 12's emscripten, does not have. The toolchain
// includes it at the start of every file, and can do without once emscripten brings libc++ 15.
#pragma once

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <ranges>
#include <string>
#include <system_error>
#include <utility>

#if _LIBCPP_VERSION < 14000
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

/// Hexadecimal numbers, which have no prefix, are rounded to nearest.
inline from_chars_result from_chars(const char* first, const char* last, double& value,
                                    chars_format format = chars_format::general) {
  const string given(first, last);
  const bool number =
      !given.empty() && given.find_first_of(" \t\n\v\f\r+xX") != 0 && given.find_first_of("xX") == string::npos;
  if (!number) return {first, errc::invalid_argument};
  const size_t sign = given[0] == '-' ? 1 : 0, prefix = format == chars_format::hex ? 2 : 0;
  string text = given;
  if (prefix != 0) text.insert(sign, "0x");
  char* end = nullptr;
  errno = 0;
  const double read = strtod(text.c_str(), &end);
  const auto length = static_cast<size_t>(end - text.c_str());
  if (length <= sign + prefix) return {first, errc::invalid_argument};
  const char* const rest = first + (length - prefix);
  if (errno == ERANGE) return {rest, errc::result_out_of_range};
  value = read;
  return {rest, errc{}};
}

/// Writes the shortest `%g` that is read as this double; without the terminating zero, as the function of that name.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const auto room = static_cast<size_t>(last - first);
  for (int digits = 1;; ++digits) {
    const auto length = static_cast<size_t>(snprintf(first, room, "%.*g", digits, value));
    if (length >= room) return {last, errc::value_too_large};
    if (digits == 17 || strtod(first, nullptr) == value) return {first + length, errc{}};
  }
}

namespace ranges {

template <class Range, class Predicate>
constexpr bool all_of(Range&& range, Predicate holds) {
  return std::all_of(begin(range), end(range), std::move(holds));
}
template <class Range, class Predicate>
constexpr bool any_of(Range&& range, Predicate holds) {
  return std::any_of(begin(range), end(range), std::move(holds));
}
template <class Range, class Value>
constexpr bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(begin(range), end(range), value);
}
template <class A, class B, class Same>
constexpr bool equal(A&& a, B&& b, Same same) {
  return std::equal(begin(a), end(a), begin(b), end(b), std::move(same));
}
template <class Range>
constexpr auto minmax(Range&& range) {
  const auto [low, high] = std::minmax_element(begin(range), end(range));
  return std::pair(*low, *high);
}
template <class Range, class Predicate>
constexpr auto partition_point(Range&& range, Predicate holds) {
  return std::partition_point(begin(range), end(range), std::move(holds));
}
template <class Range, class Value>
constexpr auto upper_bound(Range&& range, const Value& value) {
  return std::upper_bound(begin(range), end(range), value);
}
template <class A, class B, class Output>
constexpr Output set_symmetric_difference(A&& a, B&& b, Output output) {
  return std::set_symmetric_difference(begin(a), end(a), begin(b), end(b), std::move(output));
}

/// Compares what a projection makes of two elements.
template <class Less, class Projection>
constexpr auto by(Less less, Projection of) {
  return [=](const auto& a, const auto& b) { return std::invoke(less, std::invoke(of, a), std::invoke(of, b)); };
}
template <class Range, class Value, class Less = less, class Projection = identity>
constexpr auto lower_bound(Range&& range, const Value& value, Less less = {}, Projection of = {}) {
  return std::lower_bound(begin(range), end(range), value,
                          [=](const auto& a, const Value& b) { return std::invoke(less, std::invoke(of, a), b); });
}
template <class Range, class Less = less, class Projection = identity>
constexpr auto min_element(Range&& range, Less less = {}, Projection of = {}) {
  return std::min_element(begin(range), end(range), by(less, of));
}
template <class Range, class Less = less, class Projection = identity>
constexpr auto max_element(Range&& range, Less less = {}, Projection of = {}) {
  return std::max_element(begin(range), end(range), by(less, of));
}
template <class Range, class Less = less, class Projection = identity>
constexpr void sort(Range&& range, Less less = {}, Projection of = {}) {
  std::sort(begin(range), end(range), by(less, of));
}
template <class Range, class Less = less, class Projection = identity>
constexpr void stable_sort(Range&& range, Less less = {}, Projection of = {}) {
  std::stable_sort(begin(range), end(range), by(less, of));
}

}  // namespace ranges
}  // namespace std
#endif

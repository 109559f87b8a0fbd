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

/// Of decimal numbers, `nan` and `inf`; not of hexadecimal ones.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  const bool number =
      !text.empty() && text.find_first_of(" \t\n\v\f\r+xX") != 0 && text.find_first_of("xX") == string::npos;
  char* end = nullptr;
  errno = 0;
  const double read = number ? strtod(text.c_str(), &end) : 0;
  if (!number || end == text.c_str()) return {first, errc::invalid_argument};
  if (errno == ERANGE) return {first + (end - text.c_str()), errc::result_out_of_range};
  value = read;
  return {first + (end - text.c_str()), errc{}};
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
template <class A, class B, class Output>
constexpr Output set_symmetric_difference(A&& a, B&& b, Output output) {
  return std::set_symmetric_difference(begin(a), end(a), begin(b), end(b), std::move(output));
}

/// Compares what a projection makes of two elements.
template <class Less, class Projection>
constexpr auto by(Less less, Projection of) {
  return [=](const auto& a, const auto& b) { return std::invoke(less, std::invoke(of, a), std::invoke(of, b)); };
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

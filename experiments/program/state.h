// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchstone::program {

/// An error: the text does not hold the value that is read from it.
class DamagedArchive : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The values of a study's sum as text, one after the other. The files of parts hold such texts.
///
/// The same function writes and reads: `pass(value)` appends the value to a new archive, or takes it from an archive
/// that was constructed from a text. It accepts numbers, enumerators, strings; optionals, arrays, vectors, maps, pairs
/// and tuples of accepted types; and types with a function `members()` that returns std::tie of their members. Doubles
/// keep their bits; only the payload of a NaN is lost. Boost.Serialization is not used: its texts lose infinities.
class Archive {
 public:
  Archive() = default;
  explicit Archive(std::string text) : text_(std::move(text)), reading_(true) {}

  /// Throws DamagedArchive if the text does not hold such a value here.
  template <class T>
  void pass(T& value);

  /// Returns the values written so far.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Throws DamagedArchive if anything is left to read.
  void expect_end() const;

 private:
  void pass_integer(std::uint64_t& value);
  void pass_integer(std::int64_t& value);
  void pass_real(double& value);
  void pass_text(std::string& value);
  [[nodiscard]] std::string_view token();
  void append(std::string_view token);

  std::string text_;
  bool reading_ = false;
  std::size_t read_ = 0;
};

namespace detail {

template <class To, class From>
To narrowed(From number) {
  if (!std::in_range<To>(number)) throw DamagedArchive("a number is out of range");
  return static_cast<To>(number);
}

template <class T>
concept HasMembers = requires(T& value) {
  value.members();
};

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;
template <class T>
inline constexpr bool is_map = false;
template <class K, class V>
inline constexpr bool is_map<std::map<K, V>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;
template <class A, class B>
inline constexpr bool is_tuple<std::pair<A, B>> = true;

}  // namespace detail

template <class T>
void Archive::pass(T& value) {
  using namespace detail;
  const auto pass_all = [&](auto& values) {
    for (auto& one : values) pass(one);
  };
  if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
    auto number = static_cast<std::int64_t>(value);
    pass_integer(number);
    value = static_cast<T>(number);
  } else if constexpr (std::signed_integral<T>) {
    std::int64_t number = value;
    pass_integer(number);
    value = narrowed<T>(number);
  } else if constexpr (std::unsigned_integral<T>) {
    std::uint64_t number = value;
    pass_integer(number);
    value = narrowed<T>(number);
  } else if constexpr (std::is_same_v<T, double>) {
    pass_real(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    pass_text(value);
  } else if constexpr (HasMembers<T>) {
    std::apply([&](auto&... members) { (pass(members), ...); }, value.members());
  } else if constexpr (is_array<T>) {
    pass_all(value);
  } else if constexpr (is_vector<T>) {
    std::size_t size = value.size();
    pass(size);
    if (reading_ && size > text_.size()) throw DamagedArchive("a list is longer than the text");
    if (reading_ && !value.empty() && value.size() != size) throw DamagedArchive("a list has another length");
    value.resize(size);
    pass_all(value);
  } else if constexpr (is_optional<T>) {
    bool has_value = value.has_value();
    pass(has_value);
    if (reading_) has_value ? void(value.emplace()) : value.reset();
    if (has_value) pass(*value);
  } else if constexpr (is_map<T>) {
    std::vector<std::pair<typename T::key_type, typename T::mapped_type>> entries(value.begin(), value.end());
    pass(entries);
    if (reading_) value = T(entries.begin(), entries.end());
  } else {
    static_assert(is_tuple<T>, "give the type a function members() that returns std::tie of its members");
    std::apply([&](auto&... parts) { (pass(parts), ...); }, value);
  }
}

/// Returns the value as text.
template <class T>
[[nodiscard]] std::string archived(T value) {
  Archive archive;
  archive.pass(value);
  return archive.text();
}

/// Reads the value from a text that `archived` returned. Throws DamagedArchive for any other text.
template <class T>
void restore(const std::string& text, T& value) {
  Archive archive(text);
  archive.pass(value);
  archive.expect_end();
}

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

}  // namespace touchstone::program

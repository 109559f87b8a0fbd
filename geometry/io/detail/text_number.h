// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "geometry/detail/floating_point_state.h"

namespace touchstone::io {

/// Returns the field without a leading '+', which std::from_chars does not accept. "+-1" stays malformed.
inline std::string_view without_plus(std::string_view field) {
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
  return field;
}

/// Returns the integer that the field consists of; nothing if it is not an integer or does not fit.
inline std::optional<std::int64_t> whole_number(std::string_view field) {
  field = without_plus(field);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size()) return std::nullopt;
  return value;
}

/// Returns whether a well-formed number outside the range of the doubles is too large, not too close to zero: whether
/// its first nonzero digit comes before the point once the exponent is applied, which counts digits, or bits if the
/// number is hexadecimal.
inline bool is_huge(std::string_view number, bool hexadecimal) {
  const std::size_t exponent_mark = number.find_first_of(hexadecimal ? "pP" : "eE");
  const std::string_view digits = number.substr(0, exponent_mark);
  const std::size_t first = digits.find_first_not_of("-0.");
  if (first == std::string_view::npos) return false;
  std::size_t point = digits.find('.');
  if (point == std::string_view::npos) point = digits.size();
  const std::int64_t digit = hexadecimal ? 4 : 1;
  const auto order = digit * (static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first));
  if (exponent_mark == std::string_view::npos) return order > 0;

  const std::string_view exponent = number.substr(exponent_mark + 1);
  const bool negative = exponent.starts_with('-');
  const std::optional<std::int64_t> value = whole_number(exponent);
  return value ? *value > -order : !negative;  // an exponent beyond 64 bits outweighs the digits of any file
}

/// Returns the digits and exponent of a hexadecimal number without its sign, such as `1.8p-3` of `-0x1.8p-3`; nothing
/// if the field does not begin as one.
inline std::optional<std::string_view> hexadecimal(std::string_view field) {
  if (field.starts_with('-')) field.remove_prefix(1);
  if (!field.starts_with("0x") && !field.starts_with("0X")) return std::nullopt;
  field.remove_prefix(2);
  if (field.find_first_of("0123456789abcdefABCDEF.") != 0) return std::nullopt;  // std::from_chars takes "nan", too
  return field;
}

/// Returns the double nearest to the number that the field consists of, decimal or, after `0x`, hexadecimal; nothing if
/// it is not a number. Infinite beyond the finite doubles, zero near zero. Accepts "nan" and "inf" in the spellings of
/// std::from_chars. Does not depend on the caller's locale and rounding mode.
__attribute__((noinline)) inline std::optional<double> nearest_double(std::string_view field) {
  const FloatingPointState nearest;  // std::from_chars may divide in the caller's rounding mode
  field = without_plus(field);
  const std::optional<std::string_view> hex = hexadecimal(field);
  const std::string_view number = hex.value_or(field);
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value,
                                            hex ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::invalid_argument || end != number.data() + number.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range)
    value = is_huge(number, hex.has_value()) ? std::numeric_limits<double>::infinity() : 0.0;
  const bool has_lost_sign = hex || error == std::errc::result_out_of_range;
  return has_lost_sign && field.starts_with('-') ? -value : value;
}

/// Returns the integer that the field consists of, which may be written as a decimal, such as `3.0` or `1e3`. Decimals
/// are read as the nearest double and must be below 1e15, up to which integers are exact doubles.
inline std::optional<std::int64_t> whole_decimal(std::string_view field) {
  constexpr double kLimit = 1e15;
  if (const auto whole = whole_number(field)) return whole;
  const std::optional<double> value = nearest_double(field);
  if (!value || !(std::abs(*value) < kLimit) || *value != std::floor(*value)) return std::nullopt;
  return static_cast<std::int64_t>(*value);
}

}  // namespace touchstone::io

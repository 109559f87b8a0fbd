// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/run/json/mask_overflowing_numbers.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace touchstone::run {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the end of the digits that begin at `i`.
std::size_t end_of_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && is_digit(text[i])) ++i;
  return i;
}

/// Returns the end of the longest JSON number that begins at `begin`; `begin` if there is none.
std::size_t end_of_number(std::string_view text, std::size_t begin) {
  const auto at = [text](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
  const std::size_t integer = at(begin) == '-' ? begin + 1 : begin;
  std::size_t end = at(integer) == '0' ? integer + 1 : end_of_digits(text, integer);
  if (end == integer) return begin;
  if (at(end) == '.' && is_digit(at(end + 1))) end = end_of_digits(text, end + 1);
  if (at(end) == 'e' || at(end) == 'E') {
    const std::size_t exponent = at(end + 1) == '+' || at(end + 1) == '-' ? end + 2 : end + 1;
    if (is_digit(at(exponent))) end = end_of_digits(text, exponent);
  }
  return end;
}

}  // namespace

std::vector<std::size_t> mask_overflowing_numbers(std::string& text) {
  std::vector<std::size_t> replaced;
  bool in_string = false;
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = in_string ? i : end_of_number(text, i);
    if (end == i) {
      if (text[i] == '"') in_string = !in_string;
      i += in_string && text[i] == '\\' ? 2 : 1;  // an escaped quote does not end the string
      continue;
    }
    if (!std::isfinite(std::strtod(text.substr(i, end - i).c_str(), nullptr))) {
      // Sign and exponent stay, so that neighbouring characters do not become part of another number.
      const std::size_t zero = text[i] == '-' ? i + 1 : i;
      text.replace(zero, end - zero, "0e" + std::string(end - zero - 2, '0'));
      replaced.push_back(count);
    }
    ++count;
    i = end;
  }
  return replaced;
}

}  // namespace touchstone::run

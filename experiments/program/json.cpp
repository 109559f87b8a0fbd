// SPDX-License-Identifier: GPL-3.0-or-later
// nlohmann's JSON library parses. Own code handles what the library does not report: equal keys, of which it keeps the
// last; numbers beyond the finite doubles, which it refuses; and deep nesting, which it does not limit.
#include "experiments/program/json.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

#include "geometry/io/detail/legible.h"

namespace touchstone::program {

std::string json_fault(const nlohmann::json::exception& error, std::string_view text) {
  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ..."
  std::string_view message = error.what();
  const auto pass = [&message](std::string_view beginning) {
    if (message.starts_with(beginning)) message.remove_prefix(beginning.size());
  };
  if (const std::size_t tag = message.find("] ");
      message.starts_with("[json.exception.") && tag != std::string_view::npos)
    message.remove_prefix(tag + 2);
  pass("parse error at ");
  if (!text.empty() && text.find('\n') == std::string_view::npos) pass("line 1, ");
  return io::legible(message);
}

bool is_utf8(const std::string& text) {
  try {
    (void)nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

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

/// Replaces every JSON number beyond the finite doubles, such as 1e400, by a zero of the same length. Afterwards the
/// text is JSON if and only if it was before. Returns the indices of the replaced numbers among all numbers of the
/// text, from 0.
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

using nlohmann::json;
using Event = json::parse_event_t;

constexpr int kNumberOverflow = 406;  // the library's id of that error

/// `overflows`: the ascending indices, from 0, of the numbers of the text that are beyond the finite doubles.
StrictJson parse(std::string_view text, const std::vector<std::size_t>& overflows) {
  StrictJson result;
  std::vector<std::set<std::string>> open_objects;
  std::string member;
  std::size_t numbers = 0;
  result.value = json::parse(text, [&](int levels, Event event, json& parsed) {
    // The library also calls this for the content of a refused value.
    const bool opens = event == Event::object_start || event == Event::array_start;
    if (levels + (opens ? 1 : 0) > kMostLevels) {
      result.too_deep = true;
      return false;
    }
    if (event == Event::object_start) open_objects.emplace_back();
    if (event == Event::object_end) open_objects.pop_back();
    if (event == Event::key) {
      const auto& key = parsed.get_ref<const std::string&>();
      if (open_objects.size() == 1) member = key;
      if (!open_objects.back().insert(key).second) {
        result.ambiguous.insert(member);
        if (!result.duplicate_key) result.duplicate_key = key;
      }
    }
    if (event == Event::value && parsed.is_number() &&
        std::binary_search(overflows.begin(), overflows.end(), numbers++))
      parsed = std::numeric_limits<double>::infinity();
    return true;
  });
  return result;
}

}  // namespace

StrictJson read_strict_json(std::string_view text) {
  // The library would take this byte as the end of the text, and would skip a mark.
  if (text.find('\0') != std::string_view::npos) throw NotJson("a NUL byte");
  if (text.starts_with("\xEF\xBB\xBF")) throw NotJson("a byte order mark");
  try {
    return parse(text, {});
  } catch (const json::out_of_range& error) {
    if (error.id != kNumberOverflow) throw NotJson(json_fault(error, text));
  } catch (const json::exception& error) {
    throw NotJson(json_fault(error, text));
  }
  // The library refuses any text with a number like 1e400: mask these numbers and read it again.
  std::string finite(text);
  const std::vector<std::size_t> overflows = mask_overflowing_numbers(finite);
  try {
    return parse(finite, overflows);
  } catch (const json::exception& error) {
    throw NotJson(json_fault(error, text));
  }
}

}  // namespace touchstone::program

// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/strict_json.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

namespace touchstone::judge {
namespace {

using nlohmann::json;

// The library refuses a text with a number like 1e400 whole. Such a text is read again with those numbers replaced by
// this string, which no writer of cases has a use for.
constexpr std::string_view kOverflow{"\0beyond the finite doubles", 26};
constexpr std::string_view kOverflowJson = R"("\u0000beyond the finite doubles")";

constexpr int kNumberOverflow = 406;  // the library's id of that error

json parse(std::string_view text, std::optional<std::string>& duplicate_key) {
  std::vector<std::set<std::string>> open_objects;
  return json::parse(text, [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) open_objects.emplace_back();
    if (event == json::parse_event_t::object_end) open_objects.pop_back();
    if (event == json::parse_event_t::key && !duplicate_key) {
      const auto& key = parsed.get_ref<const std::string&>();
      if (!open_objects.back().insert(key).second) duplicate_key = key;
    }
    return true;
  });
}

std::string replace_overflows(std::string_view text) {
  std::string replaced;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (in_string || !(c == '-' || (c >= '0' && c <= '9'))) {
      if (c == '"') in_string = !in_string;
      const std::size_t length = in_string && c == '\\' ? 2 : 1;  // an escaped quote ends no string
      replaced += text.substr(i, length);
      i += length;
      continue;
    }
    const std::size_t end = std::min(text.find_first_not_of("0123456789+-.eE", i), text.size());
    const std::string number(text.substr(i, end - i));
    if (std::isfinite(std::strtod(number.c_str(), nullptr)))
      replaced += number;
    else
      replaced += kOverflowJson;
    i = end;
  }
  return replaced;
}

}  // namespace

StrictJson read_strict_json(std::string_view text) {
  StrictJson result;
  try {
    result.value = parse(text, result.duplicate_key);
  } catch (const json::out_of_range& error) {
    if (error.id != kNumberOverflow) throw;
    result.has_overflow = true;
    result.duplicate_key.reset();
    result.value = parse(replace_overflows(text), result.duplicate_key);
  }
  return result;
}

bool is_overflow(const json& value) { return value.is_string() && value.get_ref<const std::string&>() == kOverflow; }

}  // namespace touchstone::judge

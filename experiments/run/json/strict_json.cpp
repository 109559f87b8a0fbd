// SPDX-License-Identifier: GPL-3.0-or-later
// nlohmann's JSON library parses. Own code handles what the library does not report: equal keys, of which it keeps the
// last; numbers beyond the finite doubles, which it refuses; and deep nesting, which it does not limit.
#include "experiments/run/json/strict_json.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "experiments/run/json/json_fault.h"
#include "experiments/run/json/mask_overflowing_numbers.h"

namespace touchstone::run {
namespace {

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

}  // namespace touchstone::run

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

namespace touchstone::program {

/// Returns the fault that the JSON library found in a text, without the library's tag: `line 2, column 5: reason`, or
/// `column 5: reason` if the text is given and has one line. Columns count bytes, from 1. A reason without a place,
/// such as a missing key, stands alone. The result is printable, and long quotations are cut.
[[nodiscard]] std::string json_fault(const nlohmann::json::exception& error, std::string_view text = {});

/// Returns whether a text is UTF-8, and so can be a string of JSON.
[[nodiscard]] bool is_utf8(const std::string& text);

/// A text that is not JSON.
class NotJson : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The limit of nested arrays and objects, because values are copied, written and freed by recursion.
inline constexpr int kMostLevels = 64;

/// A JSON value, and faults that usual JSON readers do not report.
struct StrictJson {
  nlohmann::json value;                      ///< numbers beyond the finite doubles are infinite
  std::optional<std::string> duplicate_key;  ///< the first duplicate key of an object
  std::set<std::string> ambiguous;           ///< members of the outermost object that are, or hold, a duplicate key
  bool too_deep = false;                     ///< nested deeper than kMostLevels; `value` omits the deeper levels
};

/// Reads one JSON text; numbers become the nearest doubles or integers. Throws NotJson. Uses a stack of fixed size and
/// memory linear in the length of the text.
[[nodiscard]] StrictJson read_strict_json(std::string_view text);

}  // namespace touchstone::program

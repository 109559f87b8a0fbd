// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace touchstone::judge {

/// A JSON value, with what the usual reading of JSON keeps silent about.
struct StrictJson {
  nlohmann::json value;
  std::optional<std::string> duplicate_key;  ///< the first key that an object has twice
  bool has_overflow = false;                 ///< some number is beyond the finite doubles; see is_overflow
};

/// Reads one JSON text; numbers become the nearest doubles or integers.
/// Throws nlohmann::json::parse_error if the text is not JSON.
[[nodiscard]] StrictJson read_strict_json(std::string_view text);

/// Does this value of a text with `has_overflow` stand for a number beyond the finite doubles, such as 1e400?
[[nodiscard]] bool is_overflow(const nlohmann::json& value);

}  // namespace touchstone::judge

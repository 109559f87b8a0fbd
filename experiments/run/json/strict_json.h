// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "experiments/run/json/not_json.h"

namespace touchstone::run {

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

}  // namespace touchstone::run
